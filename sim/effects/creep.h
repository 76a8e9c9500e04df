#pragma once

#include <cmath>

namespace nao::sim {

/// What stands for a dry friction of `torque` [N m] that does not stick: |T| = torque tanh(|q'| /
/// creep), as damping [N m s/rad] at this rate [rad/s]; `creep` above 0 [rad/s]. A joint that has
/// not begun to move is held by half of it.
inline double creepDamping(double torque, double creep, double rate) {
  if (rate == 0) return std::abs(torque) / creep / 2;
  return std::abs(torque * std::tanh(rate / creep) / rate);
}

}  // namespace nao::sim
