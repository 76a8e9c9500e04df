#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/joint/candidate_fit.h"

namespace nao::validation {

/// A cause as it fits beside the model of a stage.
struct Candidate {
  std::size_t cause = 0;
  std::vector<double> x;
  double gain = 0;       // [nats]
  bool full = false;     // fitted with final_runs, all numbers at once
  bool weighed = false;  // its gain is by exact runs
  bool whole = false;    // these leave no more than chance does
  ModelFit fit;          // if full
};

/// Which causes fit best beside the model of a stage: looks at all, quick fits of those that
/// promise something, full fits of finalists, exact runs between those that are nearly as good.
/// Out of runs it tells what it did not try. Everything given must outlive it.
class Candidates {
 public:
  Candidates(const JointSimulator& joint, Ensemble& ensemble, const JointData& data,
             const std::vector<Cause>& causes, const Effort& effort);

  /// Best first, of each cause its best numbers. Sizes of clocks, costly to find, and the ripple
  /// of a torque that is lacked compete unless a finalist leaves no more than chance.
  std::vector<Candidate> rankedAt(const Stage& stage, const ByChance& chance);
  /// The same for the place of a cause that is in the model already: from its own numbers, of the
  /// others half as many, two in full (beside several causes one costs minutes). Sizes of clocks
  /// competed when the place was first taken.
  std::vector<Candidate> rankedAgain(const Stage& stage, double critical, const Chosen& own);
  void fitFinally(const Stage& stage, Candidate& candidate);
  /// Fits are made of coarse steps, which are off by a few per cent of what a large cause explains:
  /// exact runs decide between candidates that are as near as that.
  void weigh(const Stage& stage, const ByChance& chance, std::vector<Candidate>& ranking);

  /// Ids of causes; some more than once.
  const std::vector<std::string>& notTried() const { return not_tried_; }

 private:
  std::vector<QuickFit> startsAt(const Stage& stage, double critical, int most) const;
  void fitQuickly(const Stage& stage, const std::vector<QuickFit>& starts,
                  std::vector<Candidate>& ranking);
  void complete(const Stage& stage, double critical, int finalists,
                std::vector<Candidate>& ranking);
  bool addBeats(const Stage& stage, std::vector<Candidate>& ranking);
  bool addRipple(const Stage& stage, std::vector<Candidate>& ranking);
  void addTwins(const Stage& stage, std::vector<Candidate>& ranking);
  void fitFinalists(const Stage& stage, double critical, int most, std::vector<Candidate>& ranking);
  double leftBy(const Stage& stage, ModelFit& fit);

  const JointSimulator& joint_;
  Ensemble& ensemble_;
  const JointData& data_;
  const std::vector<Cause>& causes_;
  const Effort& effort_;
  std::vector<std::string> not_tried_;
};

/// How much less than the best another may explain without being told apart from it [nats]. A law
/// that only resembles its cause of the catalogue does not fit as well as chance allows: then
/// rivals are not told apart by chance alone.
double reachOf(const Candidate& best, const Candidate& other, double critical);

}  // namespace nao::validation
