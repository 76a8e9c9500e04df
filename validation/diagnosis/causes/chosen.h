#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {

/// A cause with its numbers, as part of a model.
struct Chosen {
  std::size_t cause = 0;  // in the list of causes
  std::vector<double> x;
};
using CauseList = std::vector<Chosen>;

std::vector<EffectSetting> settingsOf(const std::vector<Cause>& causes, const CauseList& chosen);

/// Whether the model has the cause.
bool has(const CauseList& model, std::size_t cause);

/// Of all causes, in order.
std::vector<double> numbersOf(const CauseList& model);
/// The same, a row per column of a fit's sensitivities.
Eigen::VectorXd columnOf(const CauseList& model);
/// The model with these numbers in place of its own, in order.
CauseList withNumbers(CauseList model, const std::vector<double>& numbers);

}  // namespace nao::validation
