#include "validation/diagnosis/replay/replay.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/ensemble/ensemble.h"
#include "validation/diagnosis/ensemble/start_offsets.h"

namespace nao::validation {
namespace {

struct Sums : ReplaySums {
  void addError(const RunSpread& measured, const RunSpread& ensemble, double repeats) {
    // A single run has no spread of its own: that of the model stands in.
    const Eigen::VectorXd& spread = repeats > 1 ? measured.variance : ensemble.variance;
    error += (measured.mean - ensemble.mean).squaredNorm();
    absolute += (measured.mean - ensemble.mean).cwiseAbs().sum();
    explained += (spread / repeats + ensemble.of_mean).sum();
    floor += spread.sum() / repeats;
    samples += static_cast<double>(measured.mean.size());
  }
  void addSpread(const RunSpread& measured, const RunSpread& ensemble) {
    real += measured.variance.sum();
    simulated += ensemble.variance.sum();
  }
};

void addMotion(const JointMotion& motion, const std::vector<Eigen::MatrixXd>& simulated,
               const Eigen::VectorXd& noise_free, double start_sd, Sums& sums) {
  const auto alike = [&](const std::vector<Eigen::MatrixXd>& runs, const Eigen::VectorXd& mean) {
    return startedAlike(runs, mean, motion.dt, start_sd);
  };
  const RunSpread ensemble = spreadOfPairs(simulated, 0);
  sums.addSpread(spreadOf(motion.repeats, 0), ensemble);
  sums.addError(spreadOf(alike(motion.repeats, ensemble.mean), 0),
                spreadOfPairs(alike(simulated, ensemble.mean), 0),
                static_cast<double>(motion.repeats.size()));
  const RunSpread about = spreadOf(alike(motion.repeats, noise_free), 0);
  sums.noise_free += (about.mean - noise_free).squaredNorm();
}

}  // namespace

JointReplay ReplaySums::finish(const std::string& joint) const {
  JointReplay replay;
  replay.joint = joint;
  if (samples == 0) return replay;
  const auto rms = [&](double sum) { return std::sqrt(sum / samples); };
  replay.rmse = rms(error);
  replay.mae = absolute / samples;
  replay.floor = rms(floor);
  replay.misfit = explained > 0 ? std::sqrt(error / explained) : 0;
  replay.share = error > 0 ? std::max(0.0, 1 - explained / error) : 0;
  replay.real_sd = rms(real);
  replay.simulated_sd = rms(simulated);
  replay.noise_free_rmse = rms(noise_free);
  return replay;
}

RunSpread spreadOf(const std::vector<Eigen::MatrixXd>& runs, Eigen::Index signal) {
  NAO_CHECK(!runs.empty());
  const auto count = static_cast<double>(runs.size());
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(runs[0].rows());
  RunSpread spread{none, none, none};
  for (const Eigen::MatrixXd& run : runs) spread.mean += run.col(signal) / count;
  for (const Eigen::MatrixXd& run : runs) {
    spread.variance += (run.col(signal) - spread.mean).cwiseAbs2() / std::max(1.0, count - 1);
  }
  spread.of_mean = spread.variance / count;
  return spread;
}

// Pairs know nothing of each other; deviations from the mean lack what the mean itself is off by.
RunSpread spreadOfPairs(const std::vector<Eigen::MatrixXd>& runs, Eigen::Index signal) {
  NAO_CHECK(runs.size() % 4 == 0);
  std::vector<Eigen::MatrixXd> pairs;
  for (std::size_t i = 0; i < runs.size(); i += i % 4 == 1 ? 3 : 1) {
    pairs.emplace_back((runs[i].col(signal) + runs[i + 2].col(signal)) / 2);
  }
  RunSpread spread = spreadOf(runs, signal);
  const auto count = static_cast<double>(runs.size());
  spread.of_mean = spreadOf(pairs, 0).of_mean;
  spread.variance = spread.variance * ((count - 1) / count) + spread.of_mean;
  return spread;
}

ReplayedRuns replayRuns(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        const JointNoise& noise, int runs, const std::vector<Split>& splits) {
  const std::size_t motions = joint.measured().size();
  ReplayedRuns replayed;
  replayed.noisy.resize(motions);
  replayed.noise_free.resize(motions);
  JointNoise none;
  none.quantum = noise.quantum;
  for (std::size_t m = 0; m < motions; ++m) {
    const Split split = joint.measured()[m].split;
    if (std::find(splits.begin(), splits.end(), split) == splits.end()) continue;
    for (int r = 0; r < (runs + 3) / 4 * 4; ++r) {
      const std::uint64_t stream = streamOf(StreamUse::Replay, m, r);
      replayed.noisy[m].push_back(joint.run(causes, m, stream, noise));
    }
    replayed.noise_free[m] = joint.run(causes, m, 0, none).col(0);
  }
  return replayed;
}

JointReplay compareReplay(const JointSimulator& joint, const ReplayedRuns& runs, double start_sd) {
  Sums sums;
  for (std::size_t m = 0; m < runs.noisy.size(); ++m) {
    if (runs.noisy[m].empty()) continue;
    addMotion(joint.measured()[m], runs.noisy[m], runs.noise_free[m], start_sd, sums);
  }
  return sums.finish(joint.joint());
}

JointReplay replayJoint(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        const JointNoise& noise, int runs, const std::vector<Split>& splits) {
  return compareReplay(joint, replayRuns(joint, causes, noise, runs, splits), noise.start_sd);
}

}  // namespace nao::validation
