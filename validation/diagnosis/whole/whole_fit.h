#pragma once

#include <vector>

#include "validation/diagnosis/causes/model_slopes.h"
#include "validation/diagnosis/maths/least_squares.h"
#include "validation/diagnosis/whole/whole_stage.h"

namespace nao::validation {

/// A model whose numbers were fitted to the blocks to fit.
struct WholeFit : ModelSlopes {  // raw, of the stacked means
  Eigen::VectorXd residual;      // whitened, blocks to fit
  double cost = 0;               // half its squares
};

/// Measured less simulated means, stacked; 0 beyond these blocks. `jobs`: threads.
/// Of limbs that hang: what `stage` leaves, less what coarse runs say this model changes in it.
Eigen::VectorXd simulatedResidual(const WholeTask& task, const WholeStage& stage,
                                  const CauseList& model, Blocks blocks, int jobs = 1);

/// The same of all blocks, a thread of the task each. Of robots on their feet those held back are
/// simulated by more runs: often but one was measured.
Eigen::VectorXd residualOfAll(const WholeTask& task, const WholeStage& stage,
                              const CauseList& model);

/// The same of the blocks to fit by as many runs as a look at a cause replays: rough.
Eigen::VectorXd roughResidual(const WholeTask& task, const WholeStage& stage,
                              const CauseList& model);

/// From these numbers to where the residual that `stage` whitens is least; without its jacobian.
WholeFit fitModel(const WholeTask& task, const WholeStage& stage, const CauseList& start,
                  int jobs = 1);

/// Moves the numbers of the last cause of `with` to where residuals are least; the other causes
/// keep theirs, and what these would explain if they moved a little counts for nothing. Tells which
/// of many causes are worth a fit of all numbers. Residual and cost: what is left then.
WholeFit fitLast(const WholeTask& task, const WholeStage& stage, const CauseList& with);

/// Gives a fit the jacobian of its model, and the chance in it, by the task's threads.
/// `stage`: whitens; differences are taken so wide that they are no mere chance. Null: as they
/// come. Numbers of one cause, such as a stop's slope and place, count as free of chance: they do
/// nearly the same, beside each other little else is left of them, and the cause would be told as
/// perhaps none.
void addJacobian(const WholeTask& task, WholeFit& fit, const WholeStage* stage = nullptr);

}  // namespace nao::validation
