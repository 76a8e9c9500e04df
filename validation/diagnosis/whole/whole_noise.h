#pragma once

#include <cstdint>
#include <vector>

#include "validation/diagnosis/whole/whole_data.h"

namespace nao::validation {

/// How much a diagnosis of the limb or robot level simulates. All per block of runs.
struct WholeEffort {
  int look_runs = 2;   // measured runs that a look at a cause replays
  int fit_runs = 5;    // simulated by a fit
  int base_runs = 24;  // of the model that the measurement is compared with, and as many for nulls
  int step_runs = 40;  // by either pace, of the model: four times what was measured, mostly
  int null_sets = 200;
  int finalists = 5;    // candidates that are fitted
  int most_causes = 3;  // named
};

/// Simulated runs per measured one, for `runs` in a block of `measured`.
int perRun(int runs, std::size_t measured);

/// What random numbers of simulated runs are for.
enum class WholeStream : std::uint64_t { Base = 1, Null = 2, Noise = 3 };  // 4: of step errors

/// By how much a model with its noise and repeats of a measurement scatter about their means: SDs
/// of single runs, the directions in which whole courses scatter together, and the like for the
/// means of blocks. SDs are those of simulated runs, raised by signal where the measured repeats
/// scatter more; what is left of a direction is smoothed in time (a covariance shrunk to a few
/// directions and a diagonal).
class WholeNoise {
 public:
  WholeNoise(const WholeData& data, const WholePool& pool);

  /// For residuals of means: SD by feature, and one column per direction for one SD of it.
  const Eigen::VectorXd& sd() const { return sd_; }
  const Eigen::MatrixXd& directions() const { return directions_; }
  /// By which deviations of simulated means are to be multiplied to scatter as the residual does.
  const Eigen::VectorXd& raised() const { return raised_; }

 private:
  void addBlock(const WholeData& data, const WholePool& pool, std::size_t block,
                std::vector<Eigen::VectorXd>& directions);
  static Eigen::VectorXd raise(const std::vector<FeatureGroup>& groups, Eigen::MatrixXd& simulated,
                               const Eigen::MatrixXd& measured, double per_run);
  void addRest(const std::vector<FeatureGroup>& groups, Eigen::Index at, double of_mean,
               const Eigen::MatrixXd& rest);

  Eigen::VectorXd sd_, raised_;
  Eigen::MatrixXd directions_;
};

}  // namespace nao::validation
