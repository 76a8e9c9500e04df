#pragma once

#include "core/archive.h"
#include "core/robot_io.h"

namespace nao::motion {

/// Whether a foot stands on something, by its force sensors. Grounded before the first frame.
class GroundSense {
 public:
  /// A foot with this much on it touches the ground. Free choice: a 45 N robot, FSR noise below 1
  /// N.
  static constexpr double kContact = 3;  // [N]
  /// Free choice: longer than a stride flies, shorter than a lift by hand.
  static constexpr double kPatience = 0.3;  // [s]

  static bool touches(const FootForces& foot) { return foot.total > kContact; }

  /// One cycle of `dt` [s].
  void update(const SensorFrame& measured, double dt) {
    const bool any = touches(measured.feet[0]) || touches(measured.feet[1]);
    lifted_ = any ? 0 : lifted_ + dt;
  }

  bool grounded() const { return lifted_ < kPatience; }

  void archive(Archive& archive) { archive.value(lifted_); }

 private:
  double lifted_ = 0;  // [s]
};

}  // namespace nao::motion
