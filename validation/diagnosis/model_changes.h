#pragma once

#include <map>
#include <utility>
#include <vector>

#include "validation/diagnosis/least_squares.h"
#include "validation/diagnosis/stage.h"

namespace nao::validation {

/// What the numbers of a model change of the prediction, from a stage's model on, by ensembles of
/// final_runs; remembers all it was asked.
class ModelChanges {
 public:
  /// All of it must outlive this. `start`: the model, with any numbers.
  ModelChanges(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
               const CauseList& start, const Effort& effort);

  const Halves& at(const std::vector<double>& numbers);
  /// At `near`, where neighbours do what they would at `numbers`: what a number changes for them is
  /// little (a knee's slopes are 5 % apart, a hip's 20 %), and how they rattle in their play is
  /// chance, which is halved.
  const Halves& beside(const std::vector<double>& numbers, const std::vector<double>& near);
  /// Over the stage's model [nats].
  double gain(const std::vector<double>& numbers);
  /// The change per unit of the `i`-th number, by the difference that the space asks for.
  Halves slope(const FitSpace& space, std::size_t i, const std::vector<double>& numbers);
  /// Widens a number's step until its difference is more than chance, up to half the number.
  void widen(FitSpace& space, std::size_t i);

 private:
  std::vector<EffectSetting> settings(const std::vector<double>& numbers) const;

  Ensemble& ensemble_;
  const Stage& stage_;
  const std::vector<Cause>& causes_;
  const CauseList& start_;
  const Effort& effort_;
  Halves base_;
  std::map<std::vector<double>, Halves> seen_;
  std::map<std::pair<std::vector<double>, std::vector<double>>, Halves> beside_;
};

}  // namespace nao::validation
