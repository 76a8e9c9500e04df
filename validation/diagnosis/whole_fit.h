#pragma once

#include <vector>

#include "validation/diagnosis/least_squares.h"
#include "validation/diagnosis/whole_stage.h"

namespace nao::validation {

/// A model whose numbers were fitted to the blocks to fit.
struct WholeFit {
  WholeModel model;
  Eigen::VectorXd residual;  // whitened, blocks to fit
  Eigen::MatrixXd jacobian;  // raw, stacked means by number; 0 beyond blocks to fit
  double cost = 0;           // half its squares
};

/// Measured less simulated means, stacked; 0 beyond blocks to fit if `fit_only`. `jobs`: threads.
/// Of limbs that hang: what `stage` leaves, less what coarse runs say this model changes in it.
Eigen::VectorXd simulatedResidual(const WholeTask& task, const WholeStage& stage,
                                  const WholeModel& model, bool fit_only, int jobs = 1);

/// The same of the blocks to fit by as many runs as a look at a cause replays: rough.
Eigen::VectorXd roughResidual(const WholeTask& task, const WholeStage& stage,
                              const WholeModel& model);

/// From these numbers to where the residual that `stage` whitens is least; without its jacobian.
WholeFit fitModel(const WholeTask& task, const WholeStage& stage, const WholeModel& start,
                  int jobs = 1);

/// The model with a further cause, its numbers from where `with`, whose last one it is, has them to
/// where residuals are least beside what the others' could explain, in a straight line: which of
/// many causes are worth a fit of all numbers. The cost and residual are what that leaves.
WholeFit fitLast(const WholeTask& task, const WholeStage& stage, const WholeModel& with);

/// Of the stacked means by every number of the model, a thread of the task each.
Eigen::MatrixXd jacobianOf(const WholeTask& task, const WholeModel& model);

}  // namespace nao::validation
