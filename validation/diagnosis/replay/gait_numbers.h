#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/replay/whole_run.h"

namespace nao::validation {

/// A number that sums a whole run up, as a person would compare two robots.
struct GaitNumber {
  std::string name;
  std::string unit;
  double value = 0;
  double floor = 0;  // a smaller difference is no difference, in the same unit
};

/// How far a robot came, how it swayed and how it stood, as far as the run's signals tell:
///   ahead_m, aside_m, turn_rad       where the torso ended, seen from where it began
///   steps, ahead_per_step_m ...      landings of either foot, by its force sensors
///   roll_sway_rad, pitch_sway_rad    SD of the torso's tilt about its mean
///   sway_period_s                    between rolls to the same side
///   left_share, double_support       of the weight; of the time that both feet carry
///   fallen                           1 if the torso leant by more than 45 degrees
std::vector<GaitNumber> calcGait(const WholeRun& run);

}  // namespace nao::validation
