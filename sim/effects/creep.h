#pragma once

#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {

/// Adds a dry friction of `torque` [N m] at one joint that does not stick: |T| = torque min(1, |q'|
/// / creep), `creep` above 0 [rad/s]; of both directions, or against one only.
inline void addCreep(double forward, double backward, double creep, std::size_t joint,
                     DriveTerms& terms) {
  terms.creep_forward[joint] += forward;
  terms.creep_backward[joint] += backward;
  terms.creep_slope[joint] += std::max(forward, backward) / creep;
}

}  // namespace nao::sim
