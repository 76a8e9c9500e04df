#pragma once

#include <vector>

#include "validation/diagnosis/causes/chosen.h"
#include "validation/diagnosis/causes/whole_causes.h"
#include "validation/diagnosis/maths/whitening.h"
#include "validation/diagnosis/whole/whole_noise.h"

namespace nao::validation {

std::vector<EffectSetting> settingsOf(const std::vector<PlacedCause>& causes,
                                      const CauseList& model);

/// What switching a cause on does to the means of the blocks to fit.
struct WholeLook {
  std::size_t cause = 0;
  std::vector<double> x;
  Eigen::VectorXd raw;          // all blocks; 0 beyond those to fit
  Eigen::VectorXd white;        // those to fit
  double lower = 0, upper = 0;  // how far it may be scaled
};

inline constexpr long kNoLimit = 1000000000;

/// How the search of one level simulates.
struct WholeTask {
  WholeData* data = nullptr;
  const std::vector<PlacedCause>* causes = nullptr;
  WholeEffort effort;
  NoiseParts noise;
  int jobs = 1;
  long granted = kNoLimit;  // simulated runs, of data
};

/// Runs of a model by the coarse pace: as many as a fit takes, and as a look does of the blocks to
/// fit. Of blocks held back alone, often of one measured run, more.
WholePool fitRuns(const WholeTask& task, const CauseList& model, Blocks blocks, int jobs);
WholePool slopeRuns(const WholeTask& task, const CauseList& model);  // two or more of each
WholePool lookRuns(const WholeTask& task, const CauseList& model, int jobs);

/// From now on the data make up for what coarse runs of this model are off by.
void learnStepErrors(const WholeTask& task, const CauseList& model);

/// Measured less simulated means, stacked, by as many runs as a stage makes of its own model.
Eigen::VectorXd manyRunsResidual(const WholeTask& task, const CauseList& model);

/// A model of a whole robot compared with its measurement: residual, a look at every cause, and
/// the residuals of sets that the model itself makes (nulls), undeclared differences between equal
/// robots included.
class WholeStage {
 public:
  /// `jacobian`: the change of the stacked means per number of the model. `before`: a stage whose
  /// looks serve this one too, as a whole robot costs; null: all are new.
  WholeStage(const WholeTask& task, CauseList model, const Eigen::MatrixXd& jacobian,
             const WholeStage* before = nullptr);

  const CauseList& model() const { return model_; }
  const std::vector<WholeLook>& looks() const { return looks_; }
  const std::vector<std::size_t>& notTried() const { return not_tried_; }  // out of budget
  const Eigen::VectorXd& raw() const { return raw_; }  // measured minus simulated means
  /// Simulated means of the model by the coarse runs of a fit, and of a look: to subtract from
  /// those of another model. Empty if coarse runs are as good as any.
  const Eigen::VectorXd& coarseMeans() const { return coarse_means_; }
  const Eigen::VectorXd& roughMeans() const { return rough_means_; }
  const Eigen::VectorXd& sd() const { return noise_.sd(); }
  const std::vector<Eigen::VectorXd>& nulls() const { return nulls_; }  // raw
  Eigen::Index fitSize() const { return task_.data->fitSize(); }
  double simulatedPerRun() const;  // runs of the model, for each that was measured

  /// Of a raw residual: the blocks to fit whitened; all blocks; and either without what the model's
  /// own numbers could explain.
  Eigen::VectorXd whitenFit(const Eigen::VectorXd& raw) const;
  Eigen::VectorXd whitenAll(const Eigen::VectorXd& raw) const { return all_(raw); }
  Eigen::VectorXd white(const Eigen::VectorXd& raw) const;
  Eigen::VectorXd whiteAll(const Eigen::VectorXd& raw) const;
  /// white() of what whitenFit() made of it.
  Eigen::VectorXd beside(const Eigen::VectorXd& whitened) const;

  /// What a look explains of a white() residual at its best scale [nats].
  static double gain(const WholeLook& look, const Eigen::VectorXd& white, double* scale = nullptr);
  /// The largest gains of the null sets.
  std::vector<double> nullGains() const;
  /// Mean squares of whiteAll() residuals of the null sets.
  std::vector<double> nullMisfits() const;

 private:
  void lookAtAll(const std::vector<Eigen::VectorXd>& base);
  void takeLooks(const WholeStage& before, const std::vector<Eigen::VectorXd>& base);
  void gatherUndeclared();
  void simulateDifferences(std::vector<Eigen::VectorXd>& spreads) const;
  void scaleLooks(std::vector<Eigen::VectorXd>& spreads) const;
  void addLateStarts(std::vector<Eigen::VectorXd>& directions) const;
  WholeLook look(std::size_t cause, const std::vector<double>& x,
                 const std::vector<Eigen::VectorXd>& base) const;
  void simulateNulls(const std::vector<Eigen::VectorXd>& means);

  WholeTask task_;
  CauseList model_;
  WholePool pool_;
  WholeNoise noise_;
  Eigen::VectorXd raw_, coarse_means_, rough_means_;
  std::vector<WholeLook> looks_;
  std::vector<std::size_t> not_tried_;
  Eigen::MatrixXd undeclared_;  // one SD of each difference between equal robots
  Whitening fit_, all_;
  Eigen::MatrixXd own_fit_, own_all_;  // orthonormal: what the model's numbers explain
  std::vector<Eigen::VectorXd> nulls_;
};

}  // namespace nao::validation
