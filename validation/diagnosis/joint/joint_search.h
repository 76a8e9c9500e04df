#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/beat_search.h"
#include "validation/diagnosis/joint/candidates.h"
#include "validation/diagnosis/joint/cross_validation.h"
#include "validation/diagnosis/joint/signature.h"

namespace nao::validation {

struct LinearCause;
struct SmallerModel;

/// What the null sets of a joint, simulated at its model, show by chance; one entry per set.
struct NullRecord {
  std::vector<double> gains;       // [nats] the largest of any candidate
  std::vector<double> remainders;  // misfit in SDs of itself
};

/// What a look at a cause of Scope::Robot shows at one joint: the parabola of nats that it is worth
/// at a scale, along * s - square * s^2 / 2.
struct SharedPart {
  std::size_t cause = 0;
  double x = 0;
  bool scanned = false;  // one of many sizes
  double along = 0, square = 0, gain = 0;
  double lower = 0, upper = 0;  // of the scale
};

/// What the other joints of a set show.
struct OtherJoints {
  NullRecord nulls;                             // the largest of all, by null set
  std::vector<std::vector<SharedPart>> shared;  // by joint

  /// [nats] What this number of a cause of Scope::Robot would cost those that it makes worse, as
  /// far as their looks tell.
  double costOf(std::size_t cause, double x) const;
};

/// What other joints' searches say before one begins.
struct Beside {
  std::vector<EffectSetting> effects;  // that act elsewhere and are felt here: taken for given
  std::vector<std::size_t> ruled_out;  // causes that are not tried
};

/// What one joint says of a number that all joints share, by whitened squares: its least lies at
/// along / square from here, in null sets at nulls / square.
struct SharedStep {
  double along = 0, square = 0;
  std::vector<double> nulls;
};

/// The search for the causes of one joint's misfit: forward selection with swap and elimination.
/// begin() looks at every candidate, conclude() decides with what all joints show by chance.
/// One thread.
class JointSearch {
 public:
  JointSearch(const JointSimulator& joint, const JointNoise& noise, std::vector<Cause> causes,
              const Effort& effort, long granted_runs);

  void begin(const Beside& beside = {});
  /// Once begun: looks anew beside this.
  void give(const Beside& beside);
  /// Takes a cause for given, with this number, and looks anew: what all joints share.
  void give(std::size_t cause, double x);
  /// Half the squares of the fit motions' residual with this number given, less that without: what
  /// one number for all joints would cost or save here [nats], or, of another `place`, one for
  /// these. By ensembles of final_runs.
  double costOf(std::size_t cause, const std::vector<double>& x,
                const std::vector<Joint>& place = {});
  /// By exact runs: coarse steps are off by as much as a message takes. Before give().
  SharedStep stepFrom(std::size_t cause, double x);
  /// Half the squares of the fit motions' residual that exact runs with this number given leave.
  double leftBy(std::size_t cause, double x);
  /// Sizes that this joint proposes for a cause that beats.
  std::vector<double> beatingSizesOf(std::size_t cause) {
    return beatingSizes(ensemble_, *stage_, causes_, cause);
  }
  const NullRecord& nulls() const { return nulls_; }
  std::string name() const { return joint_.joint(); }
  /// For Ensemble::setTape and setWatch.
  Ensemble& ensemble() { return ensemble_; }

  JointVerdict conclude(const OtherJoints& others);

  const std::vector<Cause>& causes() const { return causes_; }
  const Stage& stage() const { return *stage_; }
  const JointData& data() const { return data_; }

 private:
  struct Accepted {
    std::size_t cause = 0;
    double gain = 0, share = 0;
    CrossValidation validation;
    std::vector<Candidate> rivals;
    Confusion confusion{};
  };

  struct Remainder {  // what is left, in SDs of what null sets leave
    double score = 0, critical = 0;
    bool isSome() const { return score > critical; }
  };

  struct Snapshot {  // of what is accepted so far
    std::unique_ptr<Stage> stage;
    ModelFit fit;
    NullRecord nulls;
    std::vector<Accepted> accepted;
    JointNoise noise;
  };

  Snapshot snapshot() const;
  void restore(Snapshot before);
  EffectSetting sharedSetting(std::size_t cause, double x) const;  // on all joints
  std::unique_ptr<Stage> stageOf(const CauseList& model, const Eigen::MatrixXd& jacobian);
  void enter(std::unique_ptr<Stage> stage);
  void enterModel(const ModelFit& fit);
  void descend();
  double leftBy(const std::vector<EffectSetting>& causes);
  double leftBy(const CauseList& model);
  std::optional<ModelFit> nextByClock();
  std::optional<ModelFit> nextByExactRuns();
  bool isWorthAStep(double left) const;
  double critical() const;
  void drop(std::size_t place, double gain, const std::string& reason);
  bool swaps(std::size_t place, double gain, const Stage& without, const Candidate& best,
             const std::vector<Candidate>& ranking);
  bool step();
  void lookForMore();
  void noteFirsts(const std::vector<Candidate>& ranking);
  double greatestGain() const;
  bool mayBeOffBy(double gain, double greatest) const;
  bool mayBeKinsLaw(const Candidate& candidate) const;
  bool newestIsTrifle() const;
  bool newestTwoExplainLittle() const;
  bool newestIsSmall() const;
  bool accept(std::vector<Candidate> ranking);
  bool acceptOneOf(std::vector<Candidate>& ranking);
  void take(const Candidate& candidate, const CrossValidation& validation,
            const std::vector<Candidate>& ranking);
  bool takeIfBorneOut(const Candidate& candidate, const CrossValidation& validation,
                      const std::vector<Candidate>& ranking);
  bool wasRefused(const Candidate& candidate, const char* reason) const;
  bool takeIfFreed(const Candidate& candidate, const std::vector<Candidate>& ranking);
  bool takeIfNothingIsLeft(const Candidate& candidate, const std::vector<Candidate>& ranking);
  bool isAtEnd(const Chosen& one) const;
  std::optional<CrossValidation> validated(const Candidate& candidate);
  std::string objection(const Stage& stage, const Candidate& candidate,
                        const CrossValidation& validation) const;
  double shareOf(const Stage& stage, double gain) const;
  ByChance byChance() const;
  bool review();
  Eigen::MatrixXd slopesOf(std::size_t place) const;
  std::unique_ptr<Stage> stageWithout(std::size_t place) const;
  bool reviewOne(std::size_t place);
  bool takesPair(const Stage& start);
  bool mayBeTwoOthers() const;
  void enterPair(const ModelFit& fit);
  void weighEach();
  void weighBesideOthers(std::size_t place);
  bool isPairOfCauses(double greatest);
  void forgetRejected(const CauseList& found);
  bool goesWithout(std::size_t place, double gain, const Stage& without);
  bool entersAsWell(const ModelFit& fit, double gain);
  double excess() const;
  bool prune();
  ModelFit fitWithout(const SmallerModel& smaller) const;
  ModelFit fitAnew(const std::vector<std::size_t>& kept);
  std::vector<LinearCause> asLinear() const;
  bool keepOnly(const std::vector<std::size_t>& kept, const ModelFit& fit);
  void refine();
  void setRivals(std::size_t place, const std::vector<Candidate>& ranking, const Stage& stage);
  Confusion confusionAmong(const std::vector<Candidate>& ranking, const Stage& stage) const;
  Eigen::VectorXd leftAtFit() const;
  std::vector<ProfilePoint> profileOf(std::size_t place, const FoundNumber& number);
  void reject(std::size_t cause, double gain, const std::string& reason);
  std::vector<Adjustment> adjustments() const;
  void judge(JointVerdict& verdict);
  bool leansOnATrifle(const JointVerdict& verdict) const;
  void doubtThoseAtEnd(JointVerdict& verdict) const;
  Remainder remainder() const;
  Signature shapeOfUnknown() const;
  void describe(JointVerdict& verdict);
  void addFindings(JointVerdict& verdict);
  Eigen::VectorXd unroundedAngle();
  Eigen::MatrixXd movesOf(const ModelFit& fit, const Eigen::VectorXd& angle) const;
  Finding findingOf(std::size_t place) const;
  double lastGainOf(std::size_t cause, double by_look) const;
  void forgetWhatWasFound();
  void rejectTheRest();
  double misfit(const Stage& stage, const Eigen::VectorXd& raw) const;
  double splitRatio();

  const JointSimulator& joint_;
  std::vector<Cause> causes_;
  Effort effort_;
  JointData data_;
  Ensemble ensemble_;
  Candidates candidates_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<Stage> nominal_;  // before anything was taken, once something was
  ModelFit fit_;                    // of the model, where it is not empty
  Eigen::VectorXd left_;            // raw residual where its numbers came to rest
  CauseList firsts_;                // that explained something before anything was taken
  NullRecord nulls_;
  OtherJoints others_;
  std::vector<std::size_t> given_;
  double given_gain_ = 0;  // [nats] what is given explains: by a law, too
  double misfit_before_ = 0, split_ratio_ = 0;
  std::vector<Accepted> accepted_;  // in the order of the model
  // [nats] by cause that a review took out, with how much it may come back: else it would go in
  // circles.
  std::map<std::size_t, double> dropped_;
  std::map<std::size_t, double> fitted_;  // [nats] by cause, what the last round's fits gained
  std::vector<Rejected> rejected_;
  bool trying_ = false;  // whether a cause at the end of its range is freed by a second one
};

}  // namespace nao::validation
