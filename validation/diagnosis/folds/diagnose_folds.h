#pragma once

#include "validation/diagnosis/folds/fold_search.h"
#include "validation/diagnosis/joint/diagnose.h"

namespace nao::validation {

/// True if no motion of the joint was run twice: nothing tells its noise.
bool isWithoutRepeats(const JointSimulator& joint);

/// What folds say of a set, and what else a reader must know, a line each.
struct FoldedSet {
  SetDiagnosis diagnosis;  // thresholds of prediction, not of chance: gains and null sets stay 0
  std::string notes;
};

/// Diagnoses every joint of a set without repeats by folds.
FoldedSet diagnoseByFolds(const std::vector<JointTask>& tasks, const std::vector<Cause>& causes,
                          const FoldSearchOptions& options, const Team& team = {},
                          const KeptWork& kept = {});

}  // namespace nao::validation
