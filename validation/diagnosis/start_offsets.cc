#include "validation/diagnosis/start_offsets.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

constexpr double kFurthest = 2;  // SDs that a mean of starts may be off

Eigen::VectorXd rateOf(const Eigen::VectorXd& course, double dt) {
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(course.size());
  const Eigen::Index inner = course.size() - 2;
  if (inner > 0) {
    rate.segment(1, inner) = (course.tail(inner) - course.head(inner)) / (2 * dt);
  }
  return rate;
}

}  // namespace

std::vector<Eigen::MatrixXd> startedAlike(std::vector<Eigen::MatrixXd> runs,
                                          const Eigen::VectorXd& reference, double dt,
                                          double start_sd) {
  const Eigen::VectorXd rate = rateOf(reference, dt);
  const double square = rate.squaredNorm();
  if (start_sd <= 0 || square <= 0 || runs.empty()) return runs;
  const auto count = static_cast<double>(runs.size());
  Eigen::VectorXd early(runs.size());  // [s]
  for (Eigen::Index r = 0; r < early.size(); ++r) {
    early[r] = rate.dot(runs[static_cast<std::size_t>(r)].col(0) - reference) / square;
  }
  const double most = kFurthest * start_sd / std::sqrt(count);
  const double beyond = early.mean() - std::clamp(early.mean(), -most, most);
  for (Eigen::Index r = 0; r < early.size(); ++r) {
    runs[static_cast<std::size_t>(r)].col(0) -= (early[r] - beyond) * rate;
  }
  return runs;
}

}  // namespace nao::validation
