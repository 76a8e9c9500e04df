#include "validation/diagnosis/ensemble/repeats.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace nao::validation {
namespace {

constexpr double kWindow = 0.2;     // [s] free choice: longer than the noise's correlation
constexpr double kShrink = 0.2;     // of the variance that is the motion's mean one: free choice
constexpr double kSmallest = 1e-5;  // [rad], [A]: nothing is known better, so that SDs are not 0

Eigen::MatrixXd meanOf(const std::vector<Eigen::MatrixXd>& runs) {
  Eigen::MatrixXd sum = runs.front();
  for (std::size_t i = 1; i < runs.size(); ++i) sum += runs[i];
  return sum / static_cast<double>(runs.size());
}

// Centred moving average of `half` samples to each side.
Eigen::VectorXd smooth(const Eigen::VectorXd& x, Eigen::Index half) {
  Eigen::VectorXd sums(x.size() + 1);
  sums[0] = 0;
  for (Eigen::Index i = 0; i < x.size(); ++i) sums[i + 1] = sums[i] + x[i];
  Eigen::VectorXd mean(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - half);
    const Eigen::Index to = std::min(x.size(), i + half + 1);
    mean[i] = (sums[to] - sums[from]) / static_cast<double>(to - from);
  }
  return mean;
}

// 1 + 2 sum of the autocorrelations of all deviations of one signal, up to the first that is small.
double inflationOf(const std::vector<Eigen::VectorXd>& deviations) {
  const Eigen::Index n = deviations.front().size();
  double power = 0;
  for (const Eigen::VectorXd& d : deviations) power += d.squaredNorm();
  if (power <= 0) return 1;
  double sum = 1;
  for (Eigen::Index lag = 1; lag < n / 4; ++lag) {
    double product = 0;
    for (const Eigen::VectorXd& d : deviations) {
      product += d.head(n - lag).dot(d.tail(n - lag));
    }
    const double correlation = product / power;
    if (correlation < 0.05) break;
    sum += 2 * correlation;
  }
  return sum;
}

// Deviations of every run, all signals of a row of runs shifted by what its angle came late.
std::vector<Eigen::MatrixXd> deviationsOf(const std::vector<Eigen::MatrixXd>& runs,
                                          const Eigen::MatrixXd& mean, double dt) {
  Eigen::MatrixXd rate(mean.rows(), mean.cols());
  for (Eigen::Index s = 0; s < mean.cols(); ++s) rate.col(s) = rateOf(mean.col(s), dt);
  std::vector<Eigen::MatrixXd> deviations;
  for (const Eigen::MatrixXd& run : runs) {
    deviations.push_back(run - mean);
    deviations.back() += latenessOf(deviations.back().col(0), rate.col(0)) * rate;
  }
  return deviations;
}

RepeatStatistics spreadOf(const std::vector<Eigen::MatrixXd>& runs, double dt) {
  RepeatStatistics found;
  found.mean = meanOf(runs);
  found.sd = Eigen::MatrixXd::Zero(found.mean.rows(), found.mean.cols());
  found.inflation = Eigen::VectorXd::Ones(found.mean.cols());
  found.repeats = static_cast<int>(runs.size());
  const auto half = static_cast<Eigen::Index>(std::lround(kWindow / 2 / dt));
  const std::vector<Eigen::MatrixXd> all = deviationsOf(runs, found.mean, dt);
  for (Eigen::Index s = 0; s < found.mean.cols() && runs.size() > 1; ++s) {
    Eigen::VectorXd variance = Eigen::VectorXd::Zero(found.mean.rows());
    std::vector<Eigen::VectorXd> deviations;
    for (const Eigen::MatrixXd& run : all) {
      deviations.push_back(run.col(s));
      variance += deviations.back().cwiseAbs2();
    }
    variance = smooth(variance / static_cast<double>(runs.size() - 1), half);
    variance = (1 - kShrink) * variance.array() + kShrink * variance.mean();
    found.sd.col(s) = variance.cwiseSqrt().cwiseMax(kSmallest);
    for (Eigen::VectorXd& d : deviations) d = d.cwiseQuotient(found.sd.col(s));
    found.inflation[s] = inflationOf(deviations);
  }
  return found;
}

}  // namespace

Eigen::VectorXd rateOf(const Eigen::VectorXd& angle, double dt) {
  constexpr Eigen::Index kReach = 3;
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(angle.size());
  for (Eigen::Index k = 0; k < angle.size(); ++k) {
    const Eigen::Index from = std::max<Eigen::Index>(0, k - kReach);
    const Eigen::Index to = std::min(angle.size() - 1, k + kReach);
    if (to > from) rate[k] = (angle[to] - angle[from]) / (static_cast<double>(to - from) * dt);
  }
  return rate;
}

double latenessOf(const Eigen::VectorXd& deviation, const Eigen::VectorXd& rate) {
  const double moved = rate.squaredNorm();
  return moved > 0 ? -deviation.dot(rate) / moved : 0;
}

RepeatStatistics statisticsOf(const JointMotion& motion) {
  NAO_CHECK(!motion.repeats.empty());
  return spreadOf(motion.repeats, motion.dt);
}

RepeatStatistics statisticsOf(const JointMotion& motion,
                              const std::vector<Eigen::MatrixXd>& simulated) {
  RepeatStatistics found = spreadOf(simulated, motion.dt);
  found.mean = meanOf(motion.repeats);
  found.repeats = static_cast<int>(motion.repeats.size());
  return found;
}

int splitCount(int repeats) { return repeats < 2 ? 0 : repeats < 4 ? 1 : 10; }

Eigen::MatrixXd halfDifference(const JointMotion& motion, int split) {
  const auto n = static_cast<int>(motion.repeats.size());
  NAO_CHECK(n >= 2);
  std::vector<Eigen::MatrixXd> halves[2];
  for (int r = 0; r < n; ++r) {
    // Walks through the ways to deal repeats onto two piles: rotation by `split`, then alternate
    // or in blocks.
    const int place = (r + split) % n;
    const bool second = split % 2 == 0 ? place % 2 == 1 : place >= n / 2;
    halves[second ? 1 : 0].push_back(motion.repeats[static_cast<std::size_t>(r)]);
  }
  return (meanOf(halves[0]) - meanOf(halves[1])) / 2;
}

}  // namespace nao::validation
