#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/jobs/kept_runs.h"
#include "validation/diagnosis/maths/halves.h"
#include "validation/diagnosis/replay/limb_replay.h"
#include "validation/diagnosis/whole/whole_features.h"

namespace nao::validation {

/// Which blocks are simulated: all, those to fit, or those held back.
enum class Blocks { All, Fit, Held };

/// What coarse runs of some causes are off by on the mean of each block; none: not known.
struct StepErrors {
  std::vector<Eigen::VectorXd> by_block;
  double variance = 0;  // the chance in it, of the variance of a single run
  std::string of;       // the causes
};

/// What a diagnosis of the limb or robot level may see of a set, as features: a vector per run, and
/// the stacked means of all blocks, those to fit first. Commands differ from run to run (a walk
/// heeds its sensors), so every measured run is compared with simulated runs of its own commands.
class WholeData {
 public:
  /// `joints`: whose angles count; `body`: whether tilt, weight, place and gait do.
  WholeData(const WholeSimulator& simulator, const std::vector<Joint>& joints, bool body);

  const WholeSimulator& simulator() const { return simulator_; }
  const std::vector<FeatureSpace>& spaces() const { return spaces_; }  // by block
  const std::vector<Eigen::Index>& offsets() const { return offsets_; }
  Eigen::Index size() const { return size_; }
  Eigen::Index fitSize() const { return fit_size_; }
  std::size_t runs() const { return measured_.size(); }
  std::size_t joints() const { return joints_; }  // whose angles are the first groups of a space
  const Eigen::VectorXd& measured(std::size_t run) const { return measured_[run]; }

  /// Effects that act in every run simulated from now on, whatever else is tried.
  void give(std::vector<EffectSetting> effects) { given_ = std::move(effects); }

  /// From now on what is simulated is kept there, or found there.
  void keepIn(KeptRuns kept) { kept_ = std::move(kept); }

  /// A measured run anew: by the limbs of the joints alone if they hang and nothing else counts. Of
  /// others all runs are coarse.
  WholeRun replay(const std::vector<EffectSetting>& causes, std::size_t run, std::uint64_t stream,
                  const NoiseParts& noise, Pace pace) const;
  bool hasCoarse() const { return coarse_ != nullptr; }

  /// From now on simulate() makes up for what coarse runs are off by, learned from `runs` of the
  /// model with these causes by either pace. Limbs that hang alone need none of it.
  void learnStepErrors(const std::vector<EffectSetting>& causes, int runs, const NoiseParts& noise,
                       int jobs);
  const StepErrors& stepErrors() const { return step_errors_; }
  void makeUpFor(StepErrors errors) { step_errors_ = std::move(errors); }

  /// Runs simulated so far, exact ones as the coarse ones of their time.
  long used() const { return used_; }

  /// A vector per run of `by_run` (empty: left out), its mean by block, stacked.
  Eigen::VectorXd stackMeans(const std::vector<Eigen::VectorXd>& by_run) const;
  /// Of simulated runs, by every other one of each measured run: slopes differ between measured
  /// runs, which is no chance. Of a single one both halves are that.
  Halves stackHalves(const WholePool& pool) const;

  /// The features of simulated runs, `per_run` for each of the first `most` runs of every one of
  /// these blocks. What fell is left out, unless most of a block did. `streams` tells apart what
  /// the random numbers are for.
  WholePool simulate(const std::vector<EffectSetting>& causes, int per_run, std::size_t most,
                     Blocks blocks, std::uint64_t streams, const NoiseParts& noise, int jobs,
                     Pace pace = Pace::Exact) const;

 private:
  std::vector<EffectSetting> withGiven(const std::vector<EffectSetting>& causes) const;
  Eigen::VectorXd meanOf(const std::vector<EffectSetting>& acting, std::size_t block, Pace pace,
                         int count, const NoiseParts& noise, int jobs) const;
  struct Order {
    std::size_t run;
    std::uint64_t stream;
  };
  std::vector<Order> ordersFor(int per_run, std::size_t most, Blocks blocks,
                               std::uint64_t streams) const;
  WholePool run(const std::vector<EffectSetting>& acting, const std::vector<Order>& orders,
                const NoiseParts& noise, int jobs, Pace pace) const;

  const WholeSimulator& simulator_;
  std::unique_ptr<LimbReplay> limbs_, coarse_;
  std::vector<EffectSetting> given_;
  KeptRuns kept_;
  StepErrors step_errors_;
  mutable std::atomic<long> used_{0};
  std::vector<FeatureSpace> spaces_;
  std::vector<Eigen::Index> offsets_;
  std::vector<std::size_t> block_of_;  // by run
  std::vector<Eigen::VectorXd> measured_;
  std::size_t joints_ = 0;
  Eigen::Index size_ = 0, fit_size_ = 0;
};

/// The mean over the simulated runs of each measured run; empty where there are none.
std::vector<Eigen::VectorXd> meansOf(const WholePool& pool);

}  // namespace nao::validation
