#pragma once

#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// What a cause of one size changes of a whitened prediction.
struct Response {
  double size = 0;
  Eigen::VectorXd change;
};

/// A size, and half the squares of a residual that it explains [nats].
struct SizeGain {
  double size = 0, gain = 0;
};

/// The size that explains most of `residual` if responses are linear from each size to the next;
/// sizes beyond the outermost are not looked at. What a joint does at a stop tells a size to a
/// thousandth: of a row of sizes none may help at all, though one between two of them explains
/// everything. `row`: by size. Gain 0 if none helps.
SizeGain bestOnChords(const std::vector<Response>& row, const Eigen::VectorXd& residual);

/// The size at which the line through two responses explains most, at most `reach` times their
/// distance away from the first.
double alongChord(const Response& first, const Response& second, const Eigen::VectorXd& residual,
                  double reach);

}  // namespace nao::validation
