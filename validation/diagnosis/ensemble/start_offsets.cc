#include "validation/diagnosis/ensemble/start_offsets.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/ensemble/repeats.h"

namespace nao::validation {
namespace {

// SDs that a mean of starts may be off. Two are passed by chance in one of twenty motions, so in
// more than one of four sets of seven.
constexpr double kFurthest = 3;

}  // namespace

// Of a cubic spline: r[i-1] + 4 r[i] + r[i+1] = 3 (y[i+1] - y[i-1]) / dt, solved forth and back
// from what three samples say at both ends. A joint that starts and stops bends between samples: of
// 20 Hz, halves of differences over two samples miss a quarter, this 1.5 %.
Eigen::VectorXd rateBetweenSamples(const Eigen::VectorXd& course, double dt) {
  const Eigen::Index last = course.size() - 1;
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(course.size());
  if (last < 2) return rate;
  const auto& y = course;
  rate[0] = (4 * y[1] - 3 * y[0] - y[2]) / (2 * dt);
  rate[last] = (3 * y[last] + y[last - 2] - 4 * y[last - 1]) / (2 * dt);
  Eigen::VectorXd carried = Eigen::VectorXd::Zero(course.size());
  for (Eigen::Index i = 1; i < last; ++i) {
    const double pivot = 4 - carried[i - 1];
    carried[i] = 1 / pivot;
    rate[i] = (3 * (y[i + 1] - y[i - 1]) / dt - rate[i - 1]) / pivot;
  }
  for (Eigen::Index i = last - 1; i > 0; --i) rate[i] -= carried[i] * rate[i + 1];
  rate[0] = rate[last] = 0;
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
