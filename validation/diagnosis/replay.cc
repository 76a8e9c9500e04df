#include "validation/diagnosis/replay.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/start_offsets.h"

namespace nao::validation {
namespace {

struct Sums : ReplaySums {
  void addError(const RunSpread& measured, const RunSpread& ensemble, double repeats, int runs) {
    // A single run has no spread of its own: that of the model stands in.
    const Eigen::VectorXd& spread = repeats > 1 ? measured.variance : ensemble.variance;
    error += (measured.mean - ensemble.mean).squaredNorm();
    absolute += (measured.mean - ensemble.mean).cwiseAbs().sum();
    explained += (spread / repeats + ensemble.variance / runs).sum();
    floor += spread.sum() / repeats;
    samples += static_cast<double>(measured.mean.size());
  }
  void addSpread(const RunSpread& measured, const RunSpread& ensemble) {
    real += measured.variance.sum();
    simulated += ensemble.variance.sum();
  }
};

// Against `reference`, the start of every run fitted.
RunSpread spreadAbout(const std::vector<Eigen::MatrixXd>& runs, const Eigen::VectorXd& reference,
                      double dt, double start_sd) {
  return spreadOf(startedAlike(runs, reference, dt, start_sd), 0);
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
  RunSpread spread{Eigen::VectorXd::Zero(runs[0].rows()), Eigen::VectorXd::Zero(runs[0].rows())};
  for (const Eigen::MatrixXd& run : runs) spread.mean += run.col(signal) / count;
  for (const Eigen::MatrixXd& run : runs) {
    spread.variance += (run.col(signal) - spread.mean).cwiseAbs2() / std::max(1.0, count - 1);
  }
  return spread;
}

JointReplay replayJoint(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        const JointNoise& noise, int runs, const std::vector<Split>& splits) {
  Sums sums;
  for (std::size_t m = 0; m < joint.measured().size(); ++m) {
    const JointMotion& motion = joint.measured()[m];
    if (std::find(splits.begin(), splits.end(), motion.split) == splits.end()) continue;
    std::vector<Eigen::MatrixXd> simulated;
    for (int r = 0; r < runs; ++r) {
      simulated.push_back(joint.run(causes, m, static_cast<std::uint64_t>(r) + 1, noise));
    }
    JointNoise none;
    none.quantum = noise.quantum;
    const auto about = [&](const std::vector<Eigen::MatrixXd>& some, const Eigen::VectorXd& mean) {
      return spreadAbout(some, mean, motion.dt, noise.start_sd);
    };
    const RunSpread ensemble = spreadOf(simulated, 0);
    sums.addSpread(spreadOf(motion.repeats, 0), ensemble);
    sums.addError(about(motion.repeats, ensemble.mean), about(simulated, ensemble.mean),
                  static_cast<double>(motion.repeats.size()), runs);
    const Eigen::VectorXd alone = joint.run(causes, m, 0, none).col(0);
    sums.noise_free += (about(motion.repeats, alone).mean - alone).squaredNorm();
  }
  return sums.finish(joint.joint());
}

}  // namespace nao::validation
