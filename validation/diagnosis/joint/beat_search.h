#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

/// A size of a cause that beats (Cause::beats), and what a run with it explains of one motion
/// [nats]: as it is, and scaled as is best.
struct TriedSize {
  double x = 0, as_it_is = 0, scaled = 0;
};

/// Those that explain most as they are, best first, then those that do if scaled: where a single
/// run of any clock that does something is worse than none, sizes that do next to nothing are the
/// best as they are. An ankle's roll held for 14.925 ms lost 1023 nats by a run of that size, 79 by
/// one in step with the commands; scaled, it was second of 3144.
std::vector<double> bestSizes(std::vector<TriedSize> tried);

/// The best sizes of a cause that beats, by one motion: the one that shows the cause most. Two
/// clocks are told apart by their beat over a whole motion, in steps of a fraction of one turn,
/// 0.02 % of a hold of 8 ms; between them nothing is to be seen. Which is the best is for all
/// motions to say.
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
