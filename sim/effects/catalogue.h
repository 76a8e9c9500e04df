#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/effects/effect.h"

namespace nao::sim {

/// The known effects, by name. A plain value: copy it and add a candidate to try it out.
class EffectCatalogue {
 public:
  void add(EffectType type);
  const EffectType* find(std::string_view name) const;
  const std::vector<EffectType>& types() const { return types_; }

 private:
  std::vector<EffectType> types_;
};

/// Every effect of this folder.
const EffectCatalogue& standardEffects();

/// The effects of one robot in one world, in the order of its file, ready to be called.
class EffectChain {
 public:
  EffectChain() = default;
  /// `seed` feeds each effect's own random stream, named after robot, effect and place in the list;
  /// `pair` mirrors all of them.
  /// @throws InputError with file and line on an unknown effect or parameter, a value out of
  /// bounds, or a robot the effect does not fit.
  EffectChain(const EffectCatalogue& catalogue, const std::vector<EffectSetting>& settings,
              const RobotModel& model, Duration step, std::uint64_t seed,
              std::string_view robot_name, Random::Pair pair = Random::Pair::First);

  /// Back to how the run began, random numbers included.
  void restart();
  void alterPlan(BodyPlan& plan);
  void alterStart(Pose2& start);
  bool actsOnCommand() const { return !on_command_.empty(); }
  bool actsOnDrive() const { return !on_drive_.empty(); }
  void alterCommand(JointCommand& command, SimTime now, double h);
  /// Resets `terms` to those of ideal drives, then lets every effect add its own.
  void alterDrive(const DriveMoment& moment, DriveTerms& terms);
  void alterImu(SensorFrame& frame, Duration cycle);
  void alterSensors(SensorFrame& frame, Duration cycle);
  void archive(Archive& archive);
  std::map<std::string, double> draw() const;  // by "effect.name"

 private:
  std::vector<std::unique_ptr<Effect>> effects_;
  std::vector<std::string> names_;
  std::vector<unsigned char> beginning_;  // what archive() saved when all were made
  std::vector<Effect*> on_command_, on_drive_, on_imu_, on_sensors_;
};

}  // namespace nao::sim
