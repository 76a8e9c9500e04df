#pragma once

#include <cstddef>
#include <vector>

#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {

/// What the null sets of a joint, simulated at its model, show by chance; one entry per set.
struct NullRecord {
  std::vector<double> gains;       // [nats] the largest of any candidate
  std::vector<double> remainders;  // misfit in SDs of itself
};

/// What a look at a cause of Scope::Robot shows at one joint: the parabola of nats that it is worth
/// at a scale, along * s - square * s^2 / 2.
struct SharedPart {
  std::size_t cause = 0;
  double x = 0;
  bool scanned = false;  // one of many sizes
  double along = 0, square = 0, gain = 0;
  double lower = 0, upper = 0;  // of the scale
};

/// What the other joints of a set show.
struct OtherJoints {
  NullRecord nulls;                             // the largest of all, by null set
  std::vector<std::vector<SharedPart>> shared;  // by joint

  /// [nats] What this number of a cause of Scope::Robot would cost those that it makes worse, as
  /// far as their looks tell.
  double costOf(std::size_t cause, double x) const;
};

/// What other joints' searches say before one begins.
struct Beside {
  std::vector<EffectSetting> effects;  // that act elsewhere and are felt here: taken for given
  std::vector<std::size_t> ruled_out;  // causes that are not tried
};

}  // namespace nao::validation
