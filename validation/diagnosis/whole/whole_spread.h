#pragma once

#include <vector>

#include "validation/diagnosis/whole/whole_noise.h"

namespace nao::validation {

/// Second moments: how much more the repeats scatter than the model's own noise lets them.
struct WholeSpread {
  NoiseParts noise;              // of the model's own, that fits the repeats
  double low = 0, high = 0;      // torque: 99 % of sets of the model's own are told as in between
  bool differs = false;          // from the model's noise, by more than chance
  double measured_sd = 0;        // [rad] of the legs' (or all) joints, mean of runs
  double simulated_sd = 0;       // [rad] with the model's noise
  std::vector<double> by_joint;  // measured over simulated SD, as WholeSimulator::joints()
};

/// Compares the scatter of joints with that of the model with `causes`: at the nominal model before
/// anything is fitted to it, and anew with what was found, as a cause that is left out passes for
/// noise (runs of a walk that are told different things scatter by what the model makes of them).
/// Most seconds of most joints decide. `runs`: simulated per block.
WholeSpread fitSpread(const WholeData& data, const std::vector<EffectSetting>& causes, int runs,
                      int jobs);

}  // namespace nao::validation
