#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "validation/diagnosis/joint_simulator.h"

namespace nao::validation {

/// The seed of a run: a number of its own for each stream of each motion.
std::uint64_t seedOf(std::uint64_t stream, std::size_t motion);

/// By how much a run begins late [s], drawn for its stream; `most` either way. Of four streams in
/// a row (from a multiple of 4) two are as late as the other two are early, so that a mean of
/// runs begins in time: what it is late would be told as a delay, in every set the same.
double drawLateness(const JointNoise& noise, std::uint64_t stream, std::size_t motion, double most);

/// Jitter, as the effect encoder_jitter, then counts, on the first column of a run's signals.
void addEncoderNoise(const JointNoise& noise, std::uint64_t seed, Eigen::MatrixXd& signals);

}  // namespace nao::validation
