#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/joint/candidates.h"
#include "validation/diagnosis/joint/cross_validation.h"
#include "validation/diagnosis/joint/other_joints.h"

namespace nao::validation {

/// A cause that was found, and what speaks for it; its numbers are the fit's.
struct FoundCause {
  std::size_t cause = 0;
  double gain = 0, share = 0;
  CrossValidation validation;
  std::vector<Candidate> rivals;
  Confusion confusion{};
};

/// What is left, in SDs of what null sets leave.
struct Remainder {
  double score = 0, critical = 0;
  bool isSome() const { return score > critical; }
};

/// What of one joint's misfit is explained so far: the causes that were found, their numbers, and
/// what exact runs with them leave. A search may try another model and take it back.
class JointModel {
 public:
  /// `granted_runs`: how many runs may be simulated in all. The joint must outlive it.
  JointModel(const JointSimulator& joint, const JointNoise& noise, std::vector<Cause> causes,
             const Effort& effort, long granted_runs);

  const JointSimulator& joint() const { return joint_; }
  const std::vector<Cause>& causes() const { return causes_; }
  const Effort& effort() const { return effort_; }
  const JointData& data() const { return data_; }
  Ensemble& ensemble() { return ensemble_; }
  const Ensemble& ensemble() const { return ensemble_; }

  /// Begins anew, without a cause, beside this.
  void give(const Beside& beside);
  void setOthers(const OtherJoints& others) { others_ = others; }
  const OtherJoints& others() const { return others_; }

  /// In the order of the fit's.
  const std::vector<FoundCause>& found() const { return found_; }
  std::vector<FoundCause>& found() { return found_; }
  /// Makes these the causes' numbers, a Gauss-Newton step by exact runs further.
  void enter(const ModelFit& fit);
  /// Goes on by exact runs alone where these leave more than chance does: clocks, and what is
  /// beside them, or every cause.
  void descend(bool every);
  /// The last numbers, and their slopes, by exact runs.
  void refine();
  const ModelFit& fit() const { return fit_; }
  const Stage& stage() const { return *stage_; }
  /// Before anything was found; none if nothing was.
  const Stage* nominal() const { return nominal_.get(); }
  /// Raw residual where the numbers came to rest; once refined.
  const Eigen::VectorXd& left() const { return left_; }

  struct Snapshot {
    std::unique_ptr<Stage> stage;
    ModelFit fit;
    NullRecord nulls;
    std::vector<FoundCause> found;
    JointNoise noise;
  };
  Snapshot snapshot() const;
  void restore(Snapshot before);

  const NullRecord& nulls() const { return nulls_; }
  /// A gain that chance hardly ever reaches at any joint of the set [nats].
  double critical() const;
  ByChance byChance() const { return chanceOf(*stage_, critical()); }
  /// Half the squares of what is left, less what null sets leave [nats].
  double excess() const;
  /// The root of their ratio, of any raw residual: 1 is noise alone.
  double misfit(const Eigen::VectorXd& raw) const;
  Remainder remainder() const;
  /// [nats] Of any cause, or of what is given.
  double greatestGain() const;

  /// The sensitivities of one cause's numbers.
  Eigen::MatrixXd slopesOf(std::size_t place) const;
  /// The stage as it is without one of the causes.
  std::unique_ptr<Stage> stageWithout(std::size_t place) const;
  /// Whether a cause has as much as its law allows for.
  bool isAtEnd(const Chosen& one) const;
  /// Half the squares that exact runs of another model leave of the fit motions [nats].
  double leftBy(const std::vector<EffectSetting>& causes);

 private:
  std::unique_ptr<Stage> stageOf(const CauseList& model, const Eigen::MatrixXd& jacobian);
  void enter(std::unique_ptr<Stage> stage);
  double leftBy(const CauseList& model) { return leftBy(settingsOf(causes_, model)); }
  std::optional<ModelFit> nextByClock();
  std::optional<ModelFit> nextByExactRuns();
  bool isWorthAStep(double left) const;

  const JointSimulator& joint_;
  std::vector<Cause> causes_;
  Effort effort_;
  JointData data_;
  Ensemble ensemble_;
  OtherJoints others_;
  std::vector<std::size_t> given_;
  double given_gain_ = 0;  // [nats] what is given explains: by a law, too
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<Stage> nominal_;
  NullRecord nulls_;
  std::vector<FoundCause> found_;
  ModelFit fit_;
  Eigen::VectorXd left_;
};

}  // namespace nao::validation
