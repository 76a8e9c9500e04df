#include "validation/diagnosis/whole/whole_spread.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/whole/whole_scatter.h"

namespace nao::validation {
namespace {

constexpr int kSets = 100;
// Times the model's noise: less matters to nobody, and the feedback of a walk is worth as much.
constexpr double kOfInterest = 1.25;
// Of a joint's variance, that the torque noise must make for it to tell how large that is.
constexpr double kLeastMoved = 0.1;
constexpr double kLeast = 0.05;  // times the noise; less is told as this

// The mean of every second of a course, to a list; of a shorter one the mean.
void addSeconds(const Eigen::VectorXd& course, double dt, std::vector<double>& means) {
  const Eigen::Index second = std::min<Eigen::Index>(course.size(), std::lround(1 / dt));
  for (Eigen::Index at = 0; at + second <= course.size(); at += second) {
    means.push_back(course.segment(at, second).mean());
  }
}

// How runs scatter about the mean of their repeats.
struct Scatter {
  std::vector<Eigen::MatrixXd> deviations;    // by block, a column per run
  double late_squares = 0, late_degrees = 0;  // [s^2], and of freedom

  void add(const Alike& alike, double degrees) {
    for (const double late : alike.late) late_squares += late * late;
    if (!alike.late.empty()) late_degrees += degrees;
  }
};

// Starts of simulated runs make nothing of their mean (limb_replay.cc).
Scatter scatterOf(const WholeData& data, const WholePool& pool) {
  Scatter scatter;
  for (std::size_t block = 0; block < data.spaces().size(); ++block) {
    auto groups = simulatedRuns(pool, data.simulator().blocks()[block]);
    for (auto& group : groups) {
      Alike alike = startedAlike(data, block, std::move(group));
      scatter.add(alike, static_cast<double>(alike.late.size()));
      group = std::move(alike.runs);
    }
    scatter.deviations.push_back(deviationsOf(groups));
  }
  return scatter;
}

Scatter scatterOfMeasured(const WholeData& data, const WholePool& pool) {
  Scatter scatter;
  for (std::size_t block = 0; block < data.spaces().size(); ++block) {
    const Alike alike = measuredRuns(data, pool, block);
    scatter.add(alike, static_cast<double>(alike.late.size()) - 1);
    scatter.deviations.push_back(deviationsOf({alike.runs}));
  }
  return scatter;
}

// How far a joint's angles go together with themselves some bins later, the mean over these lags:
// the median over seconds. What a model lacks shakes a joint in some of them.
double momentOf(const WholeData& data, const Scatter& scatter, std::size_t joint,
                const std::vector<Eigen::Index>& lags) {
  std::vector<double> seconds;
  for (std::size_t block = 0; block < scatter.deviations.size(); ++block) {
    if (scatter.deviations[block].size() == 0) continue;
    const FeatureGroup& group = data.spaces()[block].groups()[joint];
    const auto part = scatter.deviations[block].middleRows(group.offset, group.size);
    const Eigen::Index rows = part.rows() - lags.back();
    if (rows <= 0) continue;
    Eigen::VectorXd products = Eigen::VectorXd::Zero(rows);
    for (const Eigen::Index lag : lags) {
      products += part.topRows(rows).cwiseProduct(part.middleRows(lag, rows)).rowwise().sum();
    }
    const auto count = static_cast<double>(part.cols()) * static_cast<double>(lags.size());
    addSeconds(products / count, group.dt, seconds);
  }
  return seconds.empty() ? 0 : quantile(seconds, 0.5);
}

// [rad^2] by joint. What lasts for more than a bin is the torque's; readings that are counts off do
// not last.
struct Moments {
  Eigen::VectorXd variance, lasting;
  double late = 0;  // [s] RMS by which runs begin apart
};

Moments momentsOf(const WholeData& data, const Scatter& scatter) {
  Moments moments;
  const auto joints = static_cast<Eigen::Index>(data.joints());
  moments.variance.resize(joints);
  moments.lasting.resize(joints);
  for (Eigen::Index j = 0; j < joints; ++j) {
    moments.variance[j] = momentOf(data, scatter, static_cast<std::size_t>(j), {0});
    moments.lasting[j] = momentOf(data, scatter, static_cast<std::size_t>(j), {1, 2});
  }
  if (scatter.late_degrees > 0) {
    moments.late = std::sqrt(scatter.late_squares / scatter.late_degrees);
  }
  return moments;
}

// x^2 of measured = still + x^2 (noisy - still): the median over joints that torque noise moves.
double scaleOf(const Moments& measured, const Moments& still, const Moments& noisy) {
  std::vector<double> squares;
  for (Eigen::Index j = 0; j < measured.lasting.size(); ++j) {
    const double moved = noisy.lasting[j] - still.lasting[j];
    if (moved <= kLeastMoved * noisy.lasting[j]) continue;
    squares.push_back((measured.lasting[j] - still.lasting[j]) / moved);
  }
  return squares.empty() ? 1 : std::sqrt(std::max(kLeast * kLeast, quantile(squares, 0.5)));
}

// [rad^2] by which jitter alone makes a bin of this joint scatter.
double jitterVariance(const WholeData& data, std::size_t g) {
  const WholeSimulator& simulator = data.simulator();
  const FeatureGroup& group = data.spaces()[0].groups()[g];
  const auto joint = simulator.model().findJoint(group.name);
  double square = 0;
  for (const EffectSetting& effect : simulator.model().noise) {
    const auto amplitude = effect.parameters.find("amplitude");
    if (effect.name != "encoder_jitter" || amplitude == effect.parameters.end()) continue;
    const auto& on = effect.joints;
    if (!on.empty() && std::find(on.begin(), on.end(), joint) == on.end()) continue;
    square += amplitude->second * amplitude->second;
  }
  return square / 2 * simulator.measured()[0].dt / group.dt;  // encoder_jitter.cc; mean of a bin
}

// As many simulated runs as were measured, drawn at random, each less its mean. `pool`: started
// alike.
Scatter drawSet(const WholeData& data, const WholePool& pool, Random& random) {
  const auto means = meansOf(pool);
  Scatter drawn;
  for (const WholeBlock& block : data.simulator().blocks()) {
    std::vector<Eigen::VectorXd> runs;
    for (const std::size_t run : block.runs) {
      if (pool[run].size() < 2) continue;
      const auto n = static_cast<double>(pool[run].size());
      const auto pick = static_cast<std::size_t>(random.uniform() * n);
      runs.push_back((pool[run][pick] - means[run]) * std::sqrt(n / (n - 1)));
    }
    drawn.deviations.push_back(deviationsOf({runs}));
  }
  return drawn;
}

// [s] RMS by which measured runs began apart.
double startsIn(const WholeData& data) {
  Scatter scatter;
  for (std::size_t block = 0; block < data.spaces().size(); ++block) {
    std::vector<Eigen::VectorXd> runs;
    for (const std::size_t run : data.simulator().blocks()[block].runs) {
      runs.push_back(data.measured(run));
    }
    const Alike alike = startedAlike(data, block, std::move(runs));
    scatter.add(alike, static_cast<double>(alike.late.size()) - 1);
  }
  return std::sqrt(scatter.late_squares / std::max(1.0, scatter.late_degrees));
}

// Of a model with some causes. Hanging limbs are run without jitter, which comes last: readings
// that jump by counts do not stay a count off, as others do; and they begin as those measured did.
class SpreadFit {
 public:
  SpreadFit(const WholeData& data, const std::vector<EffectSetting>& causes, int per_run,
            std::size_t most, int jobs)
      : data_(data),
        causes_(causes),
        most_(most),
        jobs_(jobs),
        jitter_(data.hasCoarse() ? 0 : 1),
        starts_(startsIn(data)),
        pool_(simulate(1, per_run)),
        still_pool_(simulate(kStill, kStillRuns)),
        noisy_(momentsOf(data, scatterOf(data, pool_))),
        still_(momentsOf(data, scatterOf(data, still_pool_))) {
    // Of hanging limbs still runs are nearer to the mean of noisy ones than the mean of few is.
    if (data.hasCoarse()) {
      measure(still_pool_, still_, kStillRuns);
    } else {
      measure(pool_, noisy_, per_run);
    }
  }

  WholeSpread fit() const {
    WholeSpread spread;
    spread.noise.torque = scaleOf(measured_, still_, noisy_);
    if (data_.hasCoarse()) fitMore(spread.noise);
    compare(spread);
    chance(spread);
    return spread;
  }

 private:
  static constexpr double kStill = 1e-6;
  static constexpr int kStillRuns = 2;

  // Means of so few simulated runs, which these commands alone make, are taken off measured ones.
  void measure(const WholePool& means, const Moments& of_one, int per_run) {
    measured_ = momentsOf(data_, scatterOfMeasured(data_, means));
    measured_.variance -= of_one.variance / per_run;
    measured_.lasting -= of_one.lasting / per_run;
  }

  WholePool simulate(double torque, int per_run) const {
    const auto stream = static_cast<std::uint64_t>(WholeStream::Noise);
    return data_.simulate(causes_, per_run, most_, Blocks::All, stream, {torque, jitter_, starts_},
                          jobs_);
  }

  // Runs of hanging limbs cost little, and tell how much readings are off and when they began. Once
  // more the torque: a joint that sticks answers to it unevenly.
  void fitMore(NoiseParts& noise) const {
    const Moments calm = momentsOf(data_, scatterOf(data_, simulate(noise.torque, 2)));
    noise.torque *= scaleOf(measured_, still_, calm);
    std::vector<double> squares;
    for (Eigen::Index j = 0; j < calm.variance.size(); ++j) {
      const double jitter = jitterVariance(data_, static_cast<std::size_t>(j));
      if (jitter > 0) squares.push_back((measured_.variance[j] - calm.variance[j]) / jitter);
    }
    if (!squares.empty()) noise.jitter = std::sqrt(std::max(0.0, quantile(squares, 0.5)));
    // Noise alone makes runs look late, too.
    const double by_noise = std::max(0.0, calm.late * calm.late - still_.late * still_.late);
    noise.start_sd = std::sqrt(std::max(0.0, starts_ * starts_ - by_noise));
  }

  void compare(WholeSpread& spread) const {
    const auto joints = measured_.variance.size();
    for (Eigen::Index j = 0; j < joints; ++j) {
      const double jitter = (1 - jitter_) * jitterVariance(data_, static_cast<std::size_t>(j));
      const double seen = std::sqrt(std::max(0.0, measured_.variance[j]));
      const double full = std::sqrt(noisy_.variance[j] + jitter);
      spread.measured_sd += seen / static_cast<double>(joints);
      spread.simulated_sd += full / static_cast<double>(joints);
      spread.by_joint.push_back(full > 0 ? seen / full : 1);
    }
  }

  void chance(WholeSpread& spread) const {
    Random random(1, "spread");
    const WholePool alike = startedAlike(data_, pool_);
    std::vector<double> scales;
    for (int set = 0; set < kSets; ++set) {
      const Moments drawn = momentsOf(data_, drawSet(data_, alike, random));
      scales.push_back(scaleOf(drawn, still_, noisy_));
    }
    spread.low = quantile(scales, 0.005);
    spread.high = quantile(scales, 0.995);
    const double torque = spread.noise.torque;
    spread.differs = (torque < spread.low || torque > spread.high) &&
                     std::abs(std::log(torque)) > std::log(kOfInterest);
  }

  const WholeData& data_;
  const std::vector<EffectSetting>& causes_;
  std::size_t most_;
  int jobs_;
  double jitter_, starts_;  // of what is simulated; [s]
  WholePool pool_, still_pool_;
  Moments noisy_, still_, measured_;
};

}  // namespace

WholeSpread fitSpread(const WholeData& data, const std::vector<EffectSetting>& causes, int runs,
                      int jobs) {
  std::size_t most = 0;
  for (const WholeBlock& block : data.simulator().blocks()) {
    most = std::max(most, block.runs.size());
  }
  WholeSpread none;
  if (data.hasCoarse()) none.noise.start_sd = data.simulator().model().start_sd;
  if (most < 2) return none;
  return SpreadFit(data, causes, std::max(4, perRun(runs, most)), most, jobs).fit();
}

}  // namespace nao::validation
