#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

/// The sizes of a cause that beats (Cause::beats) that fit one motion best, best first: the motion
/// that shows the cause most. Two clocks are told apart by their beat over a whole motion, in steps
/// of a fraction of one turn, 0.02 % of a hold of 8 ms; between them nothing is to be seen.
/// Which is the best is for all motions to say.
std::vector<double> beatingSizes(Ensemble& ensemble, const Stage& stage,
                                 const std::vector<Cause>& causes, std::size_t cause);

/// How far from `x` a size may be and still beat alike [its unit].
double beatWidth(const JointData& data, double x);

/// A size of a clock, and half the squares that exact runs with it leave [nats].
struct BeatSize {
  double x = 0, left = 0;
};

/// Coarse steps round a clock's ticks to their own and are best at another size, which has no slope
/// to follow: sizes beside it are tried, nearer and nearer. The best, or where it began.
BeatSize bestBeside(BeatSize start, double beat_width, const std::function<double(double)>& left);

}  // namespace nao::validation
