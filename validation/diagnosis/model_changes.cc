#include "validation/diagnosis/model_changes.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

constexpr double kCoherent = 0.8, kWidest = 0.5, kWider = 3;  // free choices
constexpr double kLeast = 0.05;  // of a number: what a step is at least

}  // namespace

ModelChanges::ModelChanges(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                           const CauseList& start, const Effort& effort)
    : ensemble_(ensemble),
      stage_(stage),
      causes_(causes),
      start_(start),
      effort_(effort),
      base_(ensemble.halves(settingsOf(causes, stage.model()), effort.final_runs)) {}

std::vector<EffectSetting> ModelChanges::settings(const std::vector<double>& numbers) const {
  return settingsOf(causes_, withNumbers(start_, numbers));
}

const Halves& ModelChanges::at(const std::vector<double>& numbers) {
  const auto known = seen_.find(numbers);
  if (known != seen_.end()) return known->second;
  return seen_[numbers] = ensemble_.halves(settings(numbers), effort_.final_runs) - base_;
}

const Halves& ModelChanges::beside(const std::vector<double>& numbers,
                                   const std::vector<double>& near) {
  const auto known = beside_.find({numbers, near});
  if (known != beside_.end()) return known->second;
  return beside_[{numbers, near}] =
             ensemble_.halvesBeside(settings(numbers), settings(near), effort_.final_runs) - base_;
}

double ModelChanges::gain(const std::vector<double>& numbers) {
  return Explained(stage_.whitenFit(at(numbers)), stage_.whitenFit(stage_.raw())).gain();
}

Halves ModelChanges::slope(const FitSpace& space, std::size_t i,
                           const std::vector<double>& numbers) {
  std::vector<double> near = numbers;
  near[i] += differenceStep(space, i, numbers[i]);
  return (beside(numbers, near) - at(numbers)) * (1 / (near[i] - numbers[i]));
}

void ModelChanges::widen(FitSpace& space, std::size_t i) {
  if (space.isFixed(i)) return;
  const double size = std::abs(space.start[i]), most = kWidest * size;
  while (space.step[i] < most) {
    if (stage_.whitenFit(slope(space, i, space.start)).coherence() > kCoherent) return;
    space.step[i] = std::min(kWider * std::max(space.step[i], kLeast * size), most);
  }
}

}  // namespace nao::validation
