#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/leds.h"
#include "core/lola_joints.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "naoqi_api/wire/lola_actuators.h"

namespace nao::wire {

/// What one LoLA client has asked of a robot so far: what a frame does not mention stays.
class LolaCommand {
 public:
  /// An angle may be this far beyond its joint's range [rad] and is held at its end: lists of
  /// zeros, a walk's overshoot, another version's limits. Beyond that the frame is a mistake,
  /// unless the joint is limp: some clients never set what they do not move.
  static constexpr double kTolerance = 0.5;

  explicit LolaCommand(const std::shared_ptr<const RobotModel>& model);

  /// Takes a frame in, or nothing of it. Returns what was not taken as it came, one sentence;
  /// empty: all was. @throws rpc::CallError for a stiff joint's angle far out of range.
  std::string take(const LolaActuators& frame);

  /// For the body, all of it; its number is 0. Nothing until it was asked for a joint.
  const std::optional<BodyCommand>& body() const { return body_; }

  /// Lights that are to change now.
  std::vector<LedOrder> takeLeds();

 private:
  void takeAngles(BodyCommand& body, const std::vector<double>& position, std::string& note) const;
  JointArray<double> stiffnessOf(const std::vector<double>& stiffness, std::string& note) const;

  std::shared_ptr<const RobotModel> model_;
  std::array<std::optional<Joint>, kLolaJoints.size()> joints_;
  std::optional<BodyCommand> body_;
  std::map<std::string, float> leds_;  // as asked for
  std::vector<LedOrder> changed_leds_;
};

}  // namespace nao::wire
