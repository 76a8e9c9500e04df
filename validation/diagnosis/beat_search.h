#pragma once

#include <cstddef>
#include <vector>

#include "validation/diagnosis/stage.h"

namespace nao::validation {

/// The sizes of a cause that beats (Cause::beats) that fit one motion best, best first: the motion
/// that shows the cause most. Two clocks are told apart by their beat over a whole motion, in steps
/// of a fraction of one turn, 0.02 % of a hold of 8 ms; between them nothing is to be seen.
/// Which is the best is for all motions to say.
std::vector<double> beatingSizes(Ensemble& ensemble, const Stage& stage,
                                 const std::vector<Cause>& causes, std::size_t cause);

/// How far from `x` a size may be and still beat alike [its unit].
double beatWidth(const JointData& data, double x);

}  // namespace nao::validation
