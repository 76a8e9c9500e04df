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
// Of a joint's variance, that the torque noise must make for it to tell how large that is.
constexpr double kLeastMoved = 0.1;

// The mean of every second of a course, to a list; of a shorter one the mean.
void addSeconds(const Eigen::VectorXd& course, double dt, std::vector<double>& means) {
  const Eigen::Index second = std::min<Eigen::Index>(course.size(), std::lround(1 / dt));
  for (Eigen::Index at = 0; at + second <= course.size(); at += second) {
    means.push_back(course.segment(at, second).mean());
  }
}

// Variance of the joints' angles about the means of blocks, by joint: the median over seconds. What
// a model lacks shakes a joint in some of them.
std::vector<double> jointVariance(const WholeData& data,
                                  const std::vector<Eigen::MatrixXd>& deviation) {
  std::vector<double> variance;
  for (std::size_t g = 0; g < data.joints(); ++g) {
    std::vector<double> seconds;
    for (std::size_t block = 0; block < deviation.size(); ++block) {
      if (deviation[block].size() == 0) continue;
      const FeatureGroup& group = data.spaces()[block].groups()[g];
      const auto part = deviation[block].middleRows(group.offset, group.size);
      addSeconds(part.rowwise().squaredNorm() / static_cast<double>(part.cols()), group.dt,
                 seconds);
    }
    variance.push_back(seconds.empty() ? 0 : quantile(seconds, 0.5));
  }
  return variance;
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

// x^2 of measured = still + x^2 (noisy - still): the median over joints that torque noise moves.
double scaleOf(const std::vector<double>& measured, const std::vector<double>& still,
               const std::vector<double>& noisy) {
  std::vector<double> squares;
  for (std::size_t j = 0; j < measured.size(); ++j) {
    const double moved = noisy[j] - still[j];
    if (moved > kLeastMoved * noisy[j]) squares.push_back((measured[j] - still[j]) / moved);
  }
  return squares.empty() ? 1 : std::sqrt(std::max(0.0025, quantile(squares, 0.5)));
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

WholeSpread fitSpread(const WholeData& data, const std::vector<EffectSetting>& causes, int runs,
                      int jobs) {
  std::size_t most = 0;
  RunsByBlock measured;
  for (const WholeBlock& block : data.simulator().blocks()) {
    most = std::max(most, block.runs.size());
  }
  WholeSpread spread;
  if (most < 2) return spread;
  const int per_run = std::max(4, perRun(runs, most));
  const auto streams = static_cast<std::uint64_t>(WholeStream::Noise);
  const WholePool noisy = data.simulate(causes, per_run, most, Blocks::All, streams, 1, jobs);
  const WholePool still = data.simulate(causes, 2, most, Blocks::All, streams, 1e-6, jobs);
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
