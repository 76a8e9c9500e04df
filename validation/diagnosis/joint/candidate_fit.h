#pragma once

#include <limits>
#include <vector>

#include "validation/diagnosis/causes/model_slopes.h"
#include "validation/diagnosis/joint/stage.h"
#include "validation/diagnosis/maths/slope_steps.h"

namespace nao::validation {

/// A model fitted to a joint's fit motions, all of its numbers at once.
struct ModelFit : ModelSlopes {
  Halves change;    // of the prediction, from the stage's model, all motions
  double gain = 0;  // over the stage's model [nats]
};

/// A cause added to a stage's model, the model's own numbers following linearly.
struct QuickFit {
  std::size_t cause = 0;
  std::vector<double> x;
  double gain = 0;  // [nats]
};

/// The numbers of a cause that fit best, by ensembles of look_runs. Begins at those of `start`,
/// whose gain is what they promise, and looks for the size: further numbers stay. What gains less
/// than `least` by rough runs is left at that.
QuickFit fitQuickly(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                    const QuickFit& start, const Effort& effort,
                    double least = -std::numeric_limits<double>::infinity());

/// The same of a rough cause that something shapes, from where fitQuickly() left it.
QuickFit reshaped(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                  const QuickFit& start, const Effort& effort);

/// All numbers of `start` at once, by ensembles of final_runs. `promised`: the gain that is
/// expected of its last cause.
ModelFit fitFully(Ensemble& ensemble, const JointData& data, const Stage& stage,
                  const std::vector<Cause>& causes, const CauseList& start, const Effort& effort,
                  double promised = 0);

/// Sets one column of a fit's sensitivities, by both halves.
void setSlope(ModelFit& fit, Eigen::Index column, const Halves& slope);

/// Steps along a fit's sensitivities, whitened by the stage; all numbers, or those in `columns`.
SlopeSteps stepsOf(const ModelSlopes& fit, const Stage& stage);
SlopeSteps stepsOf(const ModelSlopes& fit, const Stage& stage,
                   const std::vector<Eigen::Index>& columns);

/// Moves the numbers of a fit by one Gauss-Newton step, as `raw`, the residual that was really left
/// at them, and the fit's sensitivities ask for.
void moveNumbers(ModelFit& fit, const Eigen::VectorXd& raw, const Stage& stage,
                 const std::vector<Cause>& causes);

/// The best start of every cause that could explain at least `least` nats, best first, at most
/// `most`; two starts of one cause if the second is nearly as good, and the one whose
/// look explained most just as it was seen.
std::vector<QuickFit> startsFor(const Stage& stage, const std::vector<Cause>& causes,
                                const Eigen::VectorXd& white, double least, int most);

}  // namespace nao::validation
