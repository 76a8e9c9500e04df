#pragma once

#include <string>
#include <vector>

#include "tests/hidden/hideout.h"
#include "validation/log/simulated_recording.h"

namespace nao::hidden {

/// An entry of the catalogue, as large as comes nearest to what was hidden.
struct LookAlike {
  std::string cause;
  double value = 0;
  double apart = 0;  // [SD of the measured mean], where the two differ
};

/// A hidden effect and the robot that it is hidden in.
struct Disguise {
  validation::RecordingPlan plan;  // without it: few motions, each once, a robot that is cheap
  EffectSetting effect;
  std::string cause;   // that it stands for; empty: none of the catalogue
  std::string joint;   // that shows it
  double mean_sd = 0;  // [rad] of the measured mean of that joint
  /// Records what the effect does; null: validation::recordSimulated(), as for all others.
  validation::LogSet (*record)(const validation::RecordingPlan&) = nullptr;
};

/// How near the causes of the catalogue, other than its own, come to what it does to the angles,
/// nearest first: each is fitted alone, by the World's own laws, one number at a time; those that
/// are far beyond `below` only roughly.
std::vector<LookAlike> findLookAlikes(const Disguise& disguise, double below);

}  // namespace nao::hidden
