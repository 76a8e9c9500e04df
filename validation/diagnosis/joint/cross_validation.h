#pragma once

#include "validation/diagnosis/joint/candidate_fit.h"

namespace nao::validation {

/// How a candidate does on data that its numbers were not fitted to: every fit motion in turn,
/// every other second, and the select motions. No fold simulates: residuals and sensitivities of
/// the fit on all data are taken apart by sample. A fold counts if both of its parts excite the
/// candidate.
struct CrossValidation {
  int folds = 0;            // that counted
  int better = 0;           // of them, in which the candidate explained what it had not seen
  double gain = 0;          // [nats] on held-out parts, all folds
  int motions_excited = 0;  // fit motions in which the candidate acts at all
  /// What no fold can check is not accepted by this alone: near the threshold that is where false
  /// alarms come from.
  bool accepted() const { return 2 * better > folds; }
  bool oneMotionOnly() const { return motions_excited < 2; }
};

/// `own`: how many of the fit's numbers, the last, belong to the candidate.
CrossValidation crossValidate(const JointData& data, const Stage& stage, const ModelFit& fit,
                              std::size_t own);

}  // namespace nao::validation
