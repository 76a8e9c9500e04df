#pragma once

#include "validation/diagnosis/joint/candidate_fit.h"

namespace nao::validation {

/// Replaces a fit's sensitivities, which come from coarse runs, by exact ones: two-sided
/// differences as wide as the size of interest at least (less for stops), by `runs` runs per motion
/// to either side, an even number. At a stop or a torque limit coarse steps are off by enough to
/// move a number by several of its SDs. Where that shows mostly chance (whitened by `stage`) the
/// difference is taken wider, up to half the number, or to where a joint does something else. Sizes
/// of clocks that beat keep theirs.
void setExactSlopes(Ensemble& ensemble, const std::vector<Cause>& causes, int runs,
                    const Stage& stage, ModelFit& fit);

}  // namespace nao::validation
