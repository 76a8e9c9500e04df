#pragma once

#include "core/sim_time.h"

namespace nao::sim {

/// A round part of the ground on which soles hold less.
struct WetPatch {
  double x = 0, y = 0;  // [m] its middle
  double radius = 0;    // [m]
  double friction = 0;  // Coulomb coefficient there, if that is less than the ground's
  SimTime until{};      // dry from then on
};

}  // namespace nao::sim
