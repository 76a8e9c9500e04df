#pragma once

#include <vector>

namespace nao::validation {

class Stage;

/// What chance alone does in a joint's search [nats].
struct ByChance {
  double critical = 0;   // a gain that it hardly ever reaches
  double left = 0;       // half the squares that it leaves
  double most_left = 0;  // that it leaves in all but one of ten sets
};

/// As a stage's null sets show it; `critical` is of the whole set.
ByChance chanceOf(const Stage& stage, double critical);

/// The q-quantile of `values`, linear between order statistics.
double quantile(std::vector<double> values, double q);

}  // namespace nao::validation
