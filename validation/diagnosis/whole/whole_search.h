#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/whole/handed_on.h"
#include "validation/diagnosis/whole/whole_numbers.h"
#include "validation/diagnosis/whole/whole_spread.h"

namespace nao::validation {

/// A finding and where it was found.
struct PlacedFinding {
  Finding finding;
  std::string place;
};

/// What one level, or one limb, of a set shows.
struct WholeVerdict {
  Verdict verdict = Verdict::NoDiscrepancy;
  std::vector<PlacedFinding> findings;
  std::vector<Rejected> rejected;
  double critical_gain = 0;  // [nats] 99 % quantile of the largest gain of null sets
  double misfit_before = 0, misfit_after = 0;  // mean square, whitened, over that of null sets
  double remainder = 0, remainder_critical = 0;
  std::string signature;               // the signals that remain, the worst first
  CauseList model;                     // numbers of task.causes
  WholeSpread spread;                  // with that model; as it was told if that is empty
  std::vector<std::string> not_tried;  // as the budget was spent
  std::vector<HandedOnFate> handed_on;
};

/// The search for the causes at the limb or robot level: forward selection from looks, fits by
/// ensembles, a threshold from null sets, held-out blocks, elimination and swap, rivals, and what
/// remains. Noise, and what coarse runs are off by, are learned anew with every cause; where less
/// noise is left, those that were fitted beside the cause are compared with it again.
class WholeSearch {
 public:
  using Progress = std::function<void(const std::string&)>;
  /// `false_alarms`: the share of sets without a cause that may name one.
  /// `spread`: of the model without a cause; it replaces the task's noise.
  /// `provisional`: what a lower level found; fitted in any case, begun from its numbers.
  WholeSearch(const WholeTask& task, const WholeSpread& spread, Progress progress,
              double false_alarms = 0.01, std::vector<Provisional> provisional = {});

  WholeVerdict run();

 private:
  struct Candidate {
    std::size_t cause = 0;
    double gain = 0;
    WholeFit fit;
  };

  void enter(const WholeFit& fit);
  void learnNoise();
  void walkOn();
  void settle();
  bool step();
  struct Promise {
    double gain = 0, scale = 0;
    const WholeLook* look = nullptr;
  };
  std::vector<Promise> promises() const;
  bool leavesOnlyChance() const;
  std::vector<std::vector<Chosen>> finalists();
  void addTwins(std::vector<std::vector<Chosen>>& finalists) const;
  std::size_t sameAt(const std::string& place, std::size_t cause) const;
  std::vector<Candidate> rank();
  void preferProvisional(std::vector<Candidate>& ranking) const;
  const Provisional* provisionalOf(std::size_t cause) const;
  void lookAtProvisional();
  HandedOnFate fateOf(std::size_t number) const;
  bool accept(const std::vector<Candidate>& ranking);
  void take(const std::vector<Candidate>& ranking, const Candidate& one, double held_out);
  void compareAgain();
  std::string objection(const Candidate& candidate, double held_out) const;
  double gainByManyRuns(const Candidate& candidate) const;
  double heldOut(const CauseList& less, const CauseList& model) const;
  void review();
  bool swapOne(std::size_t place);
  void judge(WholeVerdict& verdict) const;
  void describe(WholeVerdict& verdict) const;
  bool isOfOneMotion() const;
  PlacedFinding finding(std::size_t place, const Eigen::MatrixXd& draws) const;
  std::string signature() const;

  std::vector<Chosen> beginningsOf(const WholeLook& look, double scale) const;
  CauseList bestOf(const std::vector<Chosen>& beginnings) const;
  std::vector<Candidate> fittedAlone(const std::vector<CauseList>& beginnings) const;
  std::vector<Candidate> fittedFully(const std::vector<CauseList>& beginnings) const;
  std::vector<CauseList> worthAFit(const std::vector<Candidate>& alone);
  double reachOf(const Candidate& best, const Candidate& other) const;
  std::vector<Rival> rivalsOf(const std::vector<Candidate>& ranking, const Candidate& best) const;
  const PlacedCause& placed(std::size_t cause) const { return (*task_.causes)[cause]; }
  std::string labelOf(std::size_t cause) const;
  std::vector<FoundNumber> numbersOf(const Chosen& chosen) const;
  void tell(const std::string& what) const;

  WholeTask task_;
  Progress progress_;
  double false_alarms_;
  WholeSpread nominal_, spread_;  // without and with the model
  std::unique_ptr<WholeStage> stage_;
  WholeFit fit_;  // of the model
  double critical_ = 0, spread_of_gain_ = 1;
  double misfit_before_ = 0;
  double gained_ = 0;  // [nats] by the causes accepted so far
  struct Accepted {
    double gain = 0, share = 0, held_out = 0;
    int folds = 0, folds_better = 0;
    std::vector<Rival> rivals;
    std::vector<Chosen> others;  // that were fitted beside it, to compare or swap with
  };
  std::vector<Accepted> accepted_;  // in the order of the model
  std::set<std::size_t> dropped_;   // causes that a review took out: else it would go in circles
  std::vector<Rejected> rejected_;
  std::vector<std::string> not_tried_;
  std::vector<Provisional> provisional_;
  std::vector<double> would_show_;  // of each of these [SD]
};

}  // namespace nao::validation
