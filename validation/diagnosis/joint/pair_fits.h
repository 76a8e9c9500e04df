#pragma once

#include <optional>
#include <vector>

#include "validation/diagnosis/joint/candidate_fit.h"
#include "validation/diagnosis/maths/pairs.h"

namespace nao::validation {

/// Whether all of a model alter the command: which acts first makes a difference.
bool isOrderly(const std::vector<Cause>& causes, const CauseList& model);

/// Two causes fitted at once to one joint, which no search that goes one by one may come to. What
/// each does alone, at its best number, tells which two are worth it.
class PairFits {
 public:
  /// `start`: the model without what was `found`, whose stage is `now`. All must outlive it.
  PairFits(Ensemble& ensemble, const JointData& data, const std::vector<Cause>& causes,
           const Effort& effort, const Stage& start, const Stage& now);

  /// Of `firsts`, which explained something alone, and `found`: the two that exact runs leave least
  /// of. None: out of runs, or nothing to pair.
  std::optional<ModelFit> best(const CauseList& firsts, const CauseList& found);

 private:
  std::vector<PairPart> seenAlone(const CauseList& parts);
  std::vector<CauseList> worthAFit(const CauseList& firsts, const CauseList& found);
  std::vector<ModelFit> fitted(const std::vector<CauseList>& pairs);
  double leftBy(ModelFit& fit);

  Ensemble& ensemble_;
  const JointData& data_;
  const std::vector<Cause>& causes_;
  const Effort& effort_;
  const Stage& start_;
  const Stage& now_;
};

}  // namespace nao::validation
