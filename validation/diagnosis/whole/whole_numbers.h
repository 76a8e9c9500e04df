#pragma once

#include <optional>

#include "validation/diagnosis/whole/whole_fit.h"

namespace nao::validation {

/// How far the numbers of a model fitted to whole robots may be off: a column per null set of its
/// stage, a row per number, what is to be taken off the number. In it are chance, of the
/// measurement and of as few runs as were simulated; what equal robots differ by otherwise (the
/// null sets have it) and in the numbers themselves; and, as far as signals disagree about the
/// numbers by more than in null sets, that: what the model lacks makes each want another number.
Eigen::MatrixXd drawNumbers(const WholeTask& task, const WholeStage& stage, const ModelSlopes& fit);

/// To where the many runs of a model's own stage ask its numbers to be: its fit was made by few.
struct WholeStep {
  CauseList to;
  double length = 0;  // [SD of what chance makes of it] of the number that moves most by that
};
/// Chance is within this length, a fit that went astray is not.
inline constexpr double kByChance = 4;
WholeStep stepOf(const WholeTask& task, const WholeStage& stage, const ModelSlopes& fit);

/// Whether the residual after a step, raw, speaks for it against the one before: less is left. Runs
/// of robots on their feet part by chance as soon as any number moves, which is more than most
/// steps change: there a step does, too, after which the numbers can explain less than a quarter.
bool speaksFor(const WholeTask& task, const WholeStage& stage, const Eigen::VectorXd& before,
               const Eigen::VectorXd& after);

/// Where the numbers are asked to be, if that is further than chance goes and many runs of the
/// model there speak for it by its own step errors, which the data keep then; none: they stay. By
/// step errors of other numbers a walk whose commands are 3 ms late, one and a half coarse steps,
/// was told as 2.2 ms late.
std::optional<CauseList> farStep(const WholeTask& task, const WholeStage& stage,
                                 const ModelSlopes& fit);
inline constexpr int kMostFarSteps = 3;  // one after another

/// Takes that step if it is no further than chance goes, and short or spoken for.
void refine(const WholeTask& task, const WholeStage& stage, WholeFit& fit);

}  // namespace nao::validation
