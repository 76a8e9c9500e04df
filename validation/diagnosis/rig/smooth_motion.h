#pragma once

#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// An angle and its derivatives at the rows of a run.
struct SmoothMotion {
  std::vector<double> angle;         // [rad]
  std::vector<double> rate;          // [rad/s]
  std::vector<double> acceleration;  // [rad/s^2]
};

/// The motion behind samples `dt` [s] apart, at the times of the samples plus `later` [s]: a cubic
/// fitted around every time with Gaussian weights, without any delay of its own. `bandwidth` [Hz]:
/// where the weights alone would let 1/sqrt(2) of a sine pass; the cubic keeps more of it. Beyond
/// the last sample the motion is at rest. NaN samples are passed over.
/// Savitzky and Golay 1964, with weights.
SmoothMotion smoothed(const std::vector<double>& samples, double dt, double bandwidth,
                      double later = 0);

}  // namespace nao::validation
