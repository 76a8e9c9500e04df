#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/hidden/hidden_case.h"

namespace nao::hidden {

/// How many sets of each kind, and how long the motions of joints and limbs are.
struct Counts {
  int exact_nulls = 0, near_nulls = 0, singles = 0, weak_singles = 0, pairs = 0, strangers = 0,
      data_faults = 0, mujoco_nulls = 0, mujoco_singles = 0;
  int limb_nulls = 0, limb_singles = 0, robot_nulls = 0, robot_singles = 0;  // of these levels
  double seconds = 6;
};

/// "quick", "standard" or "full", by which bars are judged. "standard" is what a change is tried
/// with: its 300 sets have motions of half the length and few robots on their feet, as it is
/// to take two cores no more than an hour and a half. @throws InputError for another word.
Counts countsOf(const std::string& preset);

/// The sets of a preset, in an order that says nothing. A third of the singles hide in laws that
/// are written separately; singles go round all causes and a dozen joints. Worlds run at 0.25 ms:
/// the reference mode knows ideal drives only, and every set has noise on its drives. Sets of
/// MuJoCo come only where it is installed.
std::vector<HiddenCase> makeCases(const Counts& counts, std::uint64_t seed);

}  // namespace nao::hidden
