#pragma once

#include <memory>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/kinematics.h"

namespace nao::motion {

/// Spares the motors of a Nao that holds still: no joint is commanded stiffer than twice what
/// gravity and the ground's push on the feet ask of it, so that joints do not press against each
/// other or the ground. What was asked for is the most. As soon as one joint is to move, the body
/// turns or a joint gives way, all have what was asked for. On until told otherwise. A value.
///   law     stiffness is a torque limit; statics of the nominal model, no external forces but
///           the soles' (NAOqi 2.8 documentation, Smart Stiffness)
class SmartStiffness {
 public:
  explicit SmartStiffness(std::shared_ptr<const RobotModel> model);

  void enable(bool on) { enabled_ = on; }

  /// One cycle of `dt` [s] with the angles commanded and the stiffness asked for.
  void update(double dt, const SensorFrame& measured, const JointArray<double>& command,
              const JointArray<double>& asked);

  /// What to command.
  const JointArray<double>& value() const { return value_; }

  /// Lists switch, clock and what is commanded.
  void archive(Archive& archive);

 private:
  bool holdsStill(const SensorFrame& measured, const JointArray<double>& command,
                  const JointArray<double>& asked) const;
  bool givesWay(const SensorFrame& measured, const JointArray<double>& command) const;
  JointArray<double> calcNeed(const SensorFrame& measured);
  JointArray<double> calcTorques(const SensorFrame& measured);

  const std::shared_ptr<const RobotModel> model_;
  Kinematics kinematics_;
  bool enabled_ = true;
  double still_ = 0;  // [s]; below 0 after a joint gave way
  JointArray<double> value_, asked_;
  JointArray<double> command_;  // [rad] of the last cycle
  JointArray<double> lag_;      // [rad] command less sensor when the body had come to rest
};

}  // namespace nao::motion
