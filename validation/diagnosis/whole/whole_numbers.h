#pragma once

#include "validation/diagnosis/whole/whole_fit.h"

namespace nao::validation {

/// How far the numbers of a model fitted to whole robots may be off: a column per null set of its
/// stage, a row per number, what is to be taken off the number. In it are chance, of the
/// measurement and of as few runs as were simulated; what equal robots differ by otherwise (the
/// null sets have it) and in the numbers themselves; and, as far as signals disagree about the
/// numbers by more than in null sets, that: what the model lacks makes each want another number.
Eigen::MatrixXd drawNumbers(const WholeTask& task, const WholeStage& stage, const WholeFit& fit);

/// To where the many runs of a model's own stage ask its numbers to be: its fit was made by few.
struct WholeStep {
  WholeModel to;
  double length = 0;  // [SD of what chance makes of it] of the number that moves most by that
};
/// Chance is within this length, a fit that went astray is not.
inline constexpr double kByChance = 4;
WholeStep stepOf(const WholeTask& task, const WholeStage& stage, const WholeFit& fit);

/// What speaks for a step of the numbers. Robots on their feet part by chance as soon as any number
/// moves, so that more may be left by all signals where the numbers are right: two walks whose
/// commands are 3 ms late were told as 2.2 ms late.
enum class Proof {
  LessIsLeft,
  LessOfItsOwn,  // or, of what the stage's own numbers explain, a quarter, and no more than chance
};
/// Whether the residual after a step, raw, speaks for it against the one before.
bool speaksFor(const WholeStage& stage, const Eigen::VectorXd& before, const Eigen::VectorXd& after,
               Proof proof);

/// Whether many runs of the model after the step speak for it; of limbs that hang, by what is left.
bool isBorneOut(const WholeTask& task, const WholeStage& stage, const WholeStep& step, Proof proof);

/// Takes that step if it is no further than chance goes and short, or borne out by either.
void refine(const WholeTask& task, const WholeStage& stage, WholeFit& fit);

}  // namespace nao::validation
