#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "validation/diagnosis/joint_simulator.h"

namespace nao::validation {

/// The seed of a run: a number of its own for each stream of each motion.
std::uint64_t seedOf(std::uint64_t stream, std::size_t motion);

/// By how much a run begins late [s], drawn by its seed; `most` either way.
double drawLateness(const JointNoise& noise, std::uint64_t seed, double most);

/// Jitter, as the effect encoder_jitter, then counts, on the first column of a run's signals.
void addEncoderNoise(const JointNoise& noise, std::uint64_t seed, Eigen::MatrixXd& signals);

}  // namespace nao::validation
