#pragma once

#include <memory>

#include "core/robot_model.h"
#include "motion/fall_detector.h"
#include "motion/phase.h"

namespace nao::motion {

/// Tells once per fall when to protect the robot. On until told otherwise.
class FallManager {
 public:
  void enable(bool on) { enabled_ = on; }

  /// One cycle of `dt` [s]: true in the cycle in which a fall begins, if switched on.
  bool update(const SensorFrame& measured, double dt);

  bool falling() const { return detector_.falling(); }
  bool fallen() const { return detector_.fallen(); }

  void archive(Archive& archive);

 private:
  FallDetector detector_;
  bool enabled_ = true;
};

/// At top speed into a pose that takes the blow with bent limbs, by the direction of the fall
/// (front, back, side), and all joints limp after that.
std::unique_ptr<Phase> protectivePose(const RobotModel& model, const SensorFrame& measured);

}  // namespace nao::motion
