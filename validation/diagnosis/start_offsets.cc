#include "validation/diagnosis/start_offsets.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/repeats.h"

namespace nao::validation {
namespace {

// SDs that a mean of starts may be off. Two are passed by chance in one of twenty motions, so in
// more than one of four sets of seven.
constexpr double kFurthest = 3;

}  // namespace

Eigen::VectorXd rateBetweenSamples(const Eigen::VectorXd& course, double dt) {
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(course.size());
  const Eigen::Index inner = course.size() - 2;
  if (inner > 0) {
    rate.segment(1, inner) = (course.tail(inner) - course.head(inner)) / (2 * dt);
  }
  return rate;
}

std::vector<Eigen::MatrixXd> startedAlike(std::vector<Eigen::MatrixXd> runs,
                                          const Eigen::VectorXd& reference, double dt,
                                          double start_sd) {
  if (start_sd <= 0 || runs.empty()) return runs;
  const Eigen::VectorXd rate = rateBetweenSamples(reference, dt);
  const auto count = static_cast<double>(runs.size());
  Eigen::VectorXd late(runs.size());  // [s]
  for (Eigen::Index r = 0; r < late.size(); ++r) {
    late[r] = latenessOf(runs[static_cast<std::size_t>(r)].col(0) - reference, rate);
  }
  const double most = kFurthest * start_sd / std::sqrt(count);
  const double beyond = late.mean() - std::clamp(late.mean(), -most, most);
  for (Eigen::Index r = 0; r < late.size(); ++r) {
    runs[static_cast<std::size_t>(r)].col(0) += (late[r] - beyond) * rate;
  }
  return runs;
}

}  // namespace nao::validation
