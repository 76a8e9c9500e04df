#include "validation/diagnosis/replay/whole_replay.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/replay/gait_numbers.h"
#include "validation/report.h"

namespace nao::validation {
namespace {

// The replays of one measured run.
struct RunReplays {
  std::vector<WholeRun> simulated;
  WholeRun noise_free;
};

std::vector<Eigen::MatrixXd> columnOf(const std::vector<WholeRun>& runs, Eigen::Index joint) {
  std::vector<Eigen::MatrixXd> columns;
  for (const WholeRun& run : runs) columns.emplace_back(run.angle.col(joint));
  return columns;
}

class Comparison {
 public:
  Comparison(const WholeSimulator& simulator, std::vector<RunReplays> replays)
      : simulator_(simulator), replays_(std::move(replays)) {}

  JointReplay compare(Joint joint) const {
    ReplaySums sums;
    for (const WholeBlock& block : simulator_.blocks()) {
      add(block, static_cast<Eigen::Index>(index(joint)), sums);
    }
    return sums.finish(simulator_.model().actuators[index(joint)].name);
  }

  std::vector<GaitReplay> compareGait() const {
    std::vector<GaitReplay> rows;
    for (const WholeBlock& block : simulator_.blocks()) addGait(block, rows);
    return rows;
  }

 private:
  // Every measured run less the mean of its own replays: what differs between these is the noise of
  // the measurement.
  void add(const WholeBlock& block, Eigen::Index joint, ReplaySums& sums) const {
    std::vector<Eigen::MatrixXd> off;
    Eigen::VectorXd alone = Eigen::VectorXd::Zero(block.rows);
    double scatter = 0, per_run = 1;
    const auto count = static_cast<double>(block.runs.size());
    for (const std::size_t run : block.runs) {
      const RunSpread ensemble = spreadOf(columnOf(replays_[run].simulated, joint), 0);
      const auto measured = simulator_.measured()[run].angle.col(joint);
      off.emplace_back(measured - ensemble.mean);
      alone += (measured - replays_[run].noise_free.angle.col(joint)) / count;
      scatter += ensemble.variance.sum() / count;
      per_run = static_cast<double>(replays_[run].simulated.size());
    }
    const RunSpread spread = spreadOf(off, 0);
    // A single run has no spread of its own: that of the model stands in.
    const double real = count > 1 ? spread.variance.sum() : scatter;
    sums.error += spread.mean.squaredNorm();
    sums.absolute += spread.mean.cwiseAbs().sum();
    sums.floor += real / count;
    sums.explained += (real + scatter / per_run) / count;
    sums.real += real;
    sums.simulated += scatter;
    sums.noise_free += alone.squaredNorm();
    sums.samples += static_cast<double>(block.rows);
  }

  void addGait(const WholeBlock& block, std::vector<GaitReplay>& rows) const {
    std::map<std::string, std::vector<double>> measured, error;
    for (const std::size_t run : block.runs) {
      std::map<std::string, double> simulated;
      for (const WholeRun& one : replays_[run].simulated) {
        const auto count = static_cast<double>(replays_[run].simulated.size());
        for (const GaitNumber& number : calcGait(one)) {
          simulated[number.name] += number.value / count;
        }
      }
      for (const GaitNumber& number : calcGait(simulator_.measured()[run])) {
        measured[number.name].push_back(number.value);
        error[number.name].push_back(simulated[number.name] - number.value);
      }
    }
    for (const GaitNumber& number : calcGait(simulator_.measured()[block.runs.front()])) {
      const Statistics of = calcStatistics(measured[number.name]);
      const double floor = of.sd / std::sqrt(static_cast<double>(of.n));
      rows.push_back({block.motion, nameOf(block.split), number.name, number.unit, of.mean,
                      calcStatistics(error[number.name]).mean, std::max(floor, number.floor)});
    }
  }

  const WholeSimulator& simulator_;
  const std::vector<RunReplays> replays_;  // by measured run
};

std::vector<RunReplays> simulateAll(const WholeSimulator& simulator,
                                    const std::vector<EffectSetting>& causes, int per_run,
                                    int jobs) {
  const auto each = static_cast<std::size_t>(per_run);
  std::vector<RunReplays> replays(simulator.measured().size());
  for (RunReplays& one : replays) one.simulated.resize(each);
  inParallel(replays.size() * (each + 1), jobs, [&](std::size_t i) {
    const std::size_t run = i / (each + 1), s = i % (each + 1);
    WholeRun& into = s < each ? replays[run].simulated[s] : replays[run].noise_free;
    // The same numbers for the same order of runs, whatever the causes.
    const std::uint64_t stream = s < each ? (run << 16) + s + 1 : 0;
    into = simulator.simulate(causes, run, stream, s < each ? 1 : 0);
  });
  return replays;
}

}  // namespace

WholeReplay replayWhole(const WholeSimulator& simulator, const std::vector<EffectSetting>& causes,
                        int per_run, int jobs) {
  WholeReplay replay;
  std::vector<RunReplays> replays = simulateAll(simulator, causes, per_run, jobs);
  for (const RunReplays& one : replays) {
    for (const WholeRun& run : one.simulated) replay.fell += run.fell;
    replay.runs += static_cast<int>(one.simulated.size());
  }
  const Comparison comparison(simulator, std::move(replays));
  for (const Joint joint : simulator.joints()) replay.joints.push_back(comparison.compare(joint));
  replay.gait = comparison.compareGait();
  return replay;
}

int runsOfEach(const WholeSimulator& simulator, int per_motion) {
  std::size_t least = simulator.measured().size();
  for (const WholeBlock& block : simulator.blocks()) least = std::min(least, block.runs.size());
  const auto runs = static_cast<int>(least);
  return std::max(2, (per_motion + runs - 1) / runs);
}

}  // namespace nao::validation
