#pragma once

#include <memory>

#include "core/robot_model.h"
#include "motion/fall_detector.h"
#include "motion/kinematics.h"
#include "motion/phase.h"

namespace nao::motion {

/// Tells once per fall when to protect the robot: it tips over, a foot stood on the ground of late,
/// and by joints and inertial unit the centre of mass is above the feet no more. So a bow, a robot
/// that is lifted up and one that lies already do not fall. On until told otherwise. A value.
class FallManager {
 public:
  explicit FallManager(std::shared_ptr<const RobotModel> model) : kinematics_(std::move(model)) {}

  void enable(bool on) { enabled_ = on; }

  /// One cycle of `dt` [s]: true in the cycle in which a fall is found, if switched on.
  bool update(const SensorFrame& measured, bool grounded, double dt);

  bool falling() const { return detector_.falling(); }
  bool fallen() const { return detector_.fallen(); }

  /// Lists switch and progress of a fall.
  void archive(Archive& archive);

 private:
  bool overbalances(const SensorFrame& measured);

  Kinematics kinematics_;
  FallDetector detector_;
  bool enabled_ = true;
  bool found_ = false;  // this fall already
};

/// At top speed into a pose that takes the blow with bent limbs, by the direction of the fall
/// (front, back, side), and all joints limp after that.
std::unique_ptr<Phase> protectivePose(const RobotModel& model, const SensorFrame& measured);

}  // namespace nao::motion
