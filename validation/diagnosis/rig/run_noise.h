#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/random.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// Where a run's random numbers come from.
struct RunDraw {
  std::uint64_t seed = 0;
  Random::Pair pair = Random::Pair::First;
};

/// Of a stream of a motion. Of four streams in a row (from a multiple of 4) the last two mirror the
/// first two: what a run's chance does in proportion to itself falls out of a mean of all four.
RunDraw drawOf(std::uint64_t stream, std::size_t motion);

/// By how much a run begins late [s]; `most` either way. A mean of runs begins in time, as pairs
/// are late and early: what it is late would be told as a delay, in every set the same.
double drawLateness(const JointNoise& noise, const RunDraw& draw, double most);

/// Jitter, as the effect encoder_jitter, then counts, on the first column of a run's signals.
void addEncoderNoise(const JointNoise& noise, const RunDraw& draw, Eigen::MatrixXd& signals);

}  // namespace nao::validation
