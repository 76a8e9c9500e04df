#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/joint/candidates.h"
#include "validation/diagnosis/joint/joint_model.h"
#include "validation/diagnosis/joint/joint_report.h"

namespace nao::validation {

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
  JointSearch(const JointSearch&) = delete;

  void begin(const Beside& beside = {});
  /// Once begun: looks anew beside this.
  void give(const Beside& beside) { model_.give(beside); }
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
  std::vector<double> beatingSizesOf(std::size_t cause);

  const NullRecord& nulls() const { return model_.nulls(); }
  std::string name() const { return model_.joint().joint(); }
  /// For Ensemble::setTape and setWatch.
  Ensemble& ensemble() { return ensemble_; }
  const std::vector<Cause>& causes() const { return causes_; }
  const Stage& stage() const { return model_.stage(); }
  const JointData& data() const { return data_; }

  JointVerdict conclude(const OtherJoints& others);

 private:
  EffectSetting sharedSetting(std::size_t cause, double x) const;  // on all joints
  double splitRatio() const;
  void reject(std::size_t cause, double gain, const std::string& reason);
  void drop(std::size_t place, double gain, const std::string& reason);

  // One cause more: joint_take.cc
  bool step();
  void lookForMore();
  void noteFirsts(const std::vector<Candidate>& ranking);
  bool accept(std::vector<Candidate> ranking);
  bool acceptOneOf(std::vector<Candidate>& ranking);
  void take(const Candidate& candidate, const CrossValidation& validation,
            const std::vector<Candidate>& ranking);
  bool takeIfBorneOut(const Candidate& candidate, const CrossValidation& validation,
                      const std::vector<Candidate>& ranking);
  bool takeIfFreed(const Candidate& candidate, const std::vector<Candidate>& ranking);
  bool takeIfNothingIsLeft(const Candidate& candidate, const std::vector<Candidate>& ranking);
  void dropWhatMayBeOff();
  bool wasRefused(const Candidate& candidate, const char* reason) const;
  std::optional<CrossValidation> validated(const Candidate& candidate);
  std::string objection(const Candidate& candidate, const CrossValidation& validation) const;
  double shareOf(const Stage& stage, double gain) const;
  bool mayBeOffBy(double gain, double greatest) const;
  bool mayBeKinsLaw(const Candidate& candidate) const;
  bool newestIsTrifle() const;
  bool newestIsSmall() const;
  bool newestTwoExplainLittle() const;

  // What was found seen again: joint_review.cc, joint_prune.cc
  bool review();
  void reviewAll();
  bool reviewOne(std::size_t place);
  bool swaps(std::size_t place, double gain, const Stage& without, const Candidate& best,
             const std::vector<Candidate>& ranking);
  bool goesWithout(std::size_t place, double gain, const Stage& without);
  bool entersAsWell(const ModelFit& fit, double gain);
  void setRivals(std::size_t place, const std::vector<Candidate>& ranking, const Stage& stage);
  bool prune();
  ModelFit fitAnew(const std::vector<std::size_t>& kept);
  bool keepOnly(const std::vector<std::size_t>& kept, const ModelFit& fit);

  // One for two: joint_twins.cc
  bool takesOneForTwo();
  double roughlyLeftBy(const CauseList& model);

  // Two at once: joint_pairs.cc
  bool takesPair(const Stage& start);
  bool mayBeTwoOthers() const;
  void enterPair(const ModelFit& fit);
  void weighEach();
  void weighBesideOthers(std::size_t place);
  bool isPairOfCauses(double greatest);
  void forgetRejected(const CauseList& found);

  JointModel model_;
  const std::vector<Cause>& causes_;
  const Effort& effort_;
  const JointData& data_;
  Ensemble& ensemble_;
  Candidates candidates_;
  CauseList firsts_;  // that explained something before anything was taken
  // [nats] by cause that a review took out, with how much it may come back: else it would go in
  // circles.
  std::map<std::size_t, double> dropped_;
  SearchNotes notes_;
  bool trying_ = false;  // whether a cause at the end of its range is freed by a second one
};

}  // namespace nao::validation
