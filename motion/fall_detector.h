#pragma once

#include "core/archive.h"
#include "core/robot_io.h"

namespace nao::motion {

/// Tells from the inertial unit's angles whether the robot is tipping over or lies. It is upright
/// before the first frame.
class FallDetector {
 public:
  /// One cycle of `dt` [s].
  void update(const SensorFrame& measured, double dt);

  bool falling() const { return falling_; }  // too far over to be standing, not yet down
  bool fallen() const { return fallen_; }    // has lain for a while

  void archive(Archive& archive);

 private:
  bool falling_ = false;
  bool fallen_ = false;
  double lying_ = 0;  // [s]
};

}  // namespace nao::motion
