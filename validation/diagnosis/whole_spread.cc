#include "validation/diagnosis/whole_spread.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/diagnosis/joint_search.h"
#include "validation/diagnosis/whole_scatter.h"

namespace nao::validation {
namespace {

using RunsByBlock = std::vector<std::vector<Eigen::VectorXd>>;

constexpr int kSets = 100;
// Times the model's noise: less matters to nobody, and the feedback of a walk is worth as much.
constexpr double kOfInterest = 1.25;

// Variance of the joints' angles about the means of blocks, by joint.
std::vector<double> jointVariance(const WholeData& data,
                                  const std::vector<Eigen::MatrixXd>& deviation) {
  const std::size_t joints = data.joints();
  std::vector<double> sum(joints, 0), count(joints, 0);
  for (std::size_t block = 0; block < deviation.size(); ++block) {
    if (deviation[block].size() == 0) continue;
    for (std::size_t g = 0; g < joints; ++g) {
      const FeatureGroup& group = data.spaces()[block].groups()[g];
      sum[g] += deviation[block].middleRows(group.offset, group.size).squaredNorm();
      count[g] += static_cast<double>(group.size * deviation[block].cols());
    }
  }
  for (std::size_t g = 0; g < joints; ++g) sum[g] /= std::max(1.0, count[g]);
  return sum;
}

std::vector<double> simulatedVariance(const WholeData& data, const WholePool& pool) {
  std::vector<Eigen::MatrixXd> by_block;
  for (const WholeBlock& block : data.simulator().blocks()) {
    by_block.push_back(deviationsOf(simulatedRuns(pool, block)));
  }
  return jointVariance(data, by_block);
}

// Of runs that are repeats of each other.
std::vector<double> repeatVariance(const WholeData& data, const RunsByBlock& by_block) {
  std::vector<Eigen::MatrixXd> deviation;
  for (const auto& runs : by_block) deviation.push_back(deviationsOf({runs}));
  return jointVariance(data, deviation);
}

// x^2 of measured = still + x^2 (noisy - still), least squares over joints in units of the noisy.
double scaleOf(const std::vector<double>& measured, const std::vector<double>& still,
               const std::vector<double>& noisy) {
  double num = 0, den = 0;
  for (std::size_t j = 0; j < measured.size(); ++j) {
    if (noisy[j] <= 0) continue;
    const double slope = (noisy[j] - still[j]) / noisy[j];
    num += slope * (measured[j] - still[j]) / noisy[j];
    den += slope * slope;
  }
  return std::sqrt(std::max(0.0025, den > 0 ? num / den : 1));
}

// As many simulated runs as were measured, drawn at random, each less its mean.
RunsByBlock drawSet(const WholeData& data, const WholePool& pool, Random& random) {
  const auto means = meansOf(pool);
  RunsByBlock drawn;
  for (const WholeBlock& block : data.simulator().blocks()) {
    auto& runs = drawn.emplace_back();
    for (const std::size_t run : block.runs) {
      if (pool[run].size() < 2) continue;
      const auto n = static_cast<double>(pool[run].size());
      const auto pick = static_cast<std::size_t>(random.uniform() * n);
      runs.push_back((pool[run][pick] - means[run]) * std::sqrt(n / (n - 1)));
    }
  }
  return drawn;
}

}  // namespace

WholeSpread fitSpread(const WholeData& data, int runs, int jobs) {
  std::size_t most = 0;
  RunsByBlock measured;
  for (const WholeBlock& block : data.simulator().blocks()) {
    most = std::max(most, block.runs.size());
  }
  WholeSpread spread;
  if (most < 2) return spread;
  const int per_run = std::max(4, perRun(runs, most));
  const auto streams = static_cast<std::uint64_t>(WholeStream::Noise);
  const WholePool noisy = data.simulate({}, per_run, most, false, streams, 1, jobs);
  const WholePool still = data.simulate({}, 2, most, false, streams, 1e-6, jobs);
  const std::vector<double> full = simulatedVariance(data, noisy);
  const std::vector<double> rest = simulatedVariance(data, still);
  for (const WholeBlock& block : data.simulator().blocks()) {
    measured.push_back(measuredRuns(data, noisy, block));
  }
  const std::vector<double> seen = repeatVariance(data, measured);
  spread.noise = scaleOf(seen, rest, full);
  for (std::size_t j = 0; j < seen.size(); ++j) {
    spread.measured_sd += std::sqrt(seen[j]) / static_cast<double>(seen.size());
    spread.simulated_sd += std::sqrt(full[j]) / static_cast<double>(seen.size());
    spread.by_joint.push_back(full[j] > 0 ? std::sqrt(seen[j] / full[j]) : 1);
  }
  Random random(1, "spread");
  std::vector<double> scales;
  for (int set = 0; set < kSets; ++set) {
    scales.push_back(scaleOf(repeatVariance(data, drawSet(data, noisy, random)), rest, full));
  }
  spread.low = quantile(scales, 0.005);
  spread.high = quantile(scales, 0.995);
  spread.differs = (spread.noise < spread.low || spread.noise > spread.high) &&
                   std::abs(std::log(spread.noise)) > std::log(kOfInterest);
  return spread;
}

}  // namespace nao::validation
