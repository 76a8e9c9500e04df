#pragma once

#include <memory>
#include <vector>

#include "core/robot_model.h"

namespace nao::validation {

/// The blocks of the thesis' basic experiments (sections 5.2.1 and 5.2.2), as robots made in code.

/// A free cube of 1 kg and 0.2 m that touches nothing; `linear_damping` [1/s] slows it by
/// a = -c v.
std::shared_ptr<const RobotModel> fallingBlock(double linear_damping);

/// Four cubes of 1 kg and 0.2 m on each other. The lowest is bolted to the world, the second turns
/// on it about y by an ideal motor of `kp` [N m/rad], the others are fixed to the second. Fixed
/// joints take no coordinates here, so that those four are two bodies.
struct BlockStack {
  double edge = 0.2;  // [m]
  double mass = 1;    // [kg] of each
  double kp = 400;    // [N m/rad] free choice: sags by 0.6 degrees, so that an error shows

  std::shared_ptr<const RobotModel> model(Duration cycle) const;
  /// The angle [rad] at which the motor, commanded to `command`, carries the three upper blocks:
  /// kp (command - angle) + 3 m g r sin(angle) = 0.
  double restAngle(double command, double gravity) const;
};

}  // namespace nao::validation
