#pragma once

#include <Eigen/Core>

#include "validation/diagnosis/causes/whole_causes.h"
#include "validation/diagnosis/replay/whole_simulator.h"

namespace nao::validation {

/// Where a stop that moves with another joint begins to move [rad of that joint] so that, at this
/// slope [rad/rad, not 0; see sim/effects/coupled_stop.cc], it is just met. One run: `other`, the
/// joint it moves with, and `left`, how far the stopped one was from its own end [rad].
double touchingPlace(const Eigen::VectorXd& other, const Eigen::VectorXd& left, double slope);

/// A joint that met such a stop went as far as it, at the turns where it met it, and nowhere
/// further: of a coupled stop, a row of slopes, each where it just touches what was measured in the
/// runs to fit. A line elsewhere meets nothing, or cuts off what was measured.
void startWhereTouched(PlacedCause& coupled, const WholeSimulator& simulator);

}  // namespace nao::validation
