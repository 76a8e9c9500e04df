#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/effects/catalogue.h"
#include "validation/diagnosis/replay/whole_run.h"

namespace nao::validation {

/// How a run is simulated. Coarse ones are for what causes change, where the error of a step falls
/// out; those of limbs that hang alone (limb_replay.h) also are before encoders round, as readings
/// that jump by a count say little of what moves them by less.
enum class Pace { Exact, Coarse };

/// How much of the noise that a robot's file states acts.
struct NoiseParts {
  NoiseParts(double torques = 1, double jitters = 1, double starts = 0)
      : torque(torques), jitter(jitters), start_sd(starts) {}

  double torque = 1;    // times its torque noise; 0: no noise at all, encoders' and IMU's neither
  double jitter = 1;    // times the amplitude by which readings of encoders are off
  double start_sd = 0;  // [s] of when limbs that hang alone begin a run
};

/// Whether the runs of a set are for a WholeSimulator: neither hung up nor built in.
bool isOnItsFeet(const LogSet& set, const RobotModel& model);

/// The runs of a motion that serve one purpose.
struct WholeBlock {
  std::string motion;
  Split split = Split::Fit;
  std::vector<std::size_t> runs;  // of WholeSimulator::measured()
  Eigen::Index rows = 0;          // of the shortest of them
};

struct WholeOptions {
  double settle = 2.5;  // [s] held in the first pose before a run: the torso's angle settles in 1 s
  const sim::EffectCatalogue* catalogue = nullptr;       // null: standardEffects()
  std::vector<Split> splits{Split::Fit, Split::Select};  // whose runs are replayed
};

/// Predicts the runs of a set whose robot stands on its feet, or hangs by its torso: the model of
/// the limb and robot levels. Every run's own commands are replayed, row by row, on the whole robot
/// with contact; what the walk made of its sensors is in them already. A robot starts level on both
/// soles, at rest, in the first row's pose. One object may be asked by several threads at once.
class WholeSimulator {
 public:
  /// Test runs are left out unless asked for, which only `gain` does. @throws InputError.
  WholeSimulator(const LogSet& set, std::shared_ptr<const RobotModel> model,
                 const WholeOptions& options = {});

  const RobotModel& model() const { return *model_; }
  Duration step(Pace pace) const;
  const std::vector<WholeRun>& measured() const { return measured_; }
  /// In the order of WholeOptions::splits.
  const std::vector<WholeBlock>& blocks() const { return blocks_; }
  const std::vector<Joint>& joints() const { return joints_; }  // that were measured
  /// Those of them whose angles count. Feet on the ground hold the two hinges of a shared motor
  /// against each other within their play, in a way that no sensor tells and a replay can not know.
  std::vector<Joint> judged() const;
  const sim::EffectCatalogue& catalogue() const;

  /// measured()[run] on the model with these causes. A cause is a deviation from the model
  /// (merge_effects.h). The same `stream` draws the same random numbers whatever the causes.
  WholeRun simulate(const std::vector<EffectSetting>& causes, std::size_t run, std::uint64_t stream,
                    const NoiseParts& noise, Pace pace = Pace::Exact) const;

  /// The robot as it was in this run, with what acted on it: noise first.
  std::shared_ptr<const RobotModel> robotOf(const WholeRun& run,
                                            const std::vector<EffectSetting>& causes,
                                            const NoiseParts& noise) const;

 private:
  std::shared_ptr<const RobotModel> model_;
  WholeOptions options_;
  std::vector<WholeRun> measured_;
  std::vector<bool> walks_;  // by run
  std::vector<WholeBlock> blocks_;
  std::vector<Joint> joints_;
};

}  // namespace nao::validation
