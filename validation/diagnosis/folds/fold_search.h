#pragma once

#include <functional>
#include <string>

#include "validation/diagnosis/causes/verdict.h"
#include "validation/diagnosis/folds/fold_fits.h"

namespace nao::validation {

struct FoldSearchOptions {
  MotionFitOptions fit;
  int most_causes = 6;
  int tried = 6;  // causes of each round that are fitted, by what one look at them promises
  /// A cause must lower the mean held-out error by this part, and in more than half of the folds.
  double least_gain = 0.02;
  long granted = 1000000000;  // runs; none is begun that searches further when they are used up
  int sets = 400;             // drawn for the intervals
  std::vector<double> gains;  // of the servo by motion, relative to the model's; empty: all alike
  int jobs = 1;               // threads; the result is the same
  std::function<void(const std::string&)> progress;
};

/// What a set without repeats shows of one joint.
struct FoldDiagnosis {
  JointVerdict verdict;
  std::vector<Fold> folds;
  FoldErrors before, after;  // held out
  double fitted = 0;         // [rad] error of the motions that the final numbers were fitted to
};

/// The causes of one joint where nothing tells noise: forward selection by the error of folds that
/// no fit has seen. A fold's numbers come from the other folds alone, from the first start on, so
/// that a blind set of another gain is no harder than the folds were. Then every cause must still
/// help beside the others. All `fit` and `select` motions serve; intervals draw the logs again.
FoldDiagnosis searchByFolds(const JointSimulator& joint, const std::vector<Cause>& causes,
                            const FoldSearchOptions& options);

}  // namespace nao::validation
