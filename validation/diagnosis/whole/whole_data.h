#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/jobs/kept_runs.h"
#include "validation/diagnosis/maths/halves.h"
#include "validation/diagnosis/replay/limb_replay.h"
#include "validation/diagnosis/whole/whole_features.h"

namespace nao::validation {

/// Which blocks are simulated: all, those to fit, or those held back.
enum class Blocks { All, Fit, Held };

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

  /// From now on simulate() makes up for what coarse runs are off by on the mean of a block,
  /// learned from `runs` of the model by either pace. Limbs that hang alone need none of it.
  void learnStepErrors(int runs, const NoiseParts& noise, int jobs);
  /// The chance in that, of the variance of a single run; 0 if nothing is made up for.
  double stepErrorVariance() const { return step_error_variance_; }

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
  Eigen::VectorXd meanOf(std::size_t block, Pace pace, int count, const NoiseParts& noise,
                         int jobs) const;
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
  std::vector<Eigen::VectorXd> step_error_;  // by block; empty: not known
  double step_error_variance_ = 0;
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
