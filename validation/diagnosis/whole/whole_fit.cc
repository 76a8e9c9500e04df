#include "validation/diagnosis/whole/whole_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/maths/valley.h"

namespace nao::validation {
namespace {

// Of a fit: one number moves nearly straight to its place, several along valleys.
constexpr int kIterations = 3, kIterationsOfSeveral = 10;

// How far to either side of a number its column of a jacobian looks, in steps of a fit. Runs of
// robots on their feet part by chance however near their numbers are: over one step that made a
// column a third too long, and numbers were told too sure and too near where they began.
constexpr double kBeside = 4;
// If it is still chance, by how much further, up to this part of the number, and when it is not.
constexpr double kWider = 2, kWidest = 0.7, kCoherent = 0.7;

// Of a coupled stop's sizes of interest: joints meet stops within milliradians, and wider steps
// take the way there for a part of the slope. How steep it is moves it as far as where it begins
// does: wider steps of the one alone hid that the two make up for each other, and -0.44 were told
// as -0.491 to -0.476. On the feet chance is larger than what such steps do.
constexpr double kSteepnessStep = 0.01, kPlaceStep = 0.05;

double stepOf(const WholeTask& task, std::size_t cause, std::size_t number, double x) {
  const Cause& of = (*task.causes)[cause].cause;
  const double smallest = of.free[number].smallest;
  if (of.coupled && task.data->hasCoarse()) {
    return (number == 0 ? kSteepnessStep : kPlaceStep) * smallest;
  }
  return std::max({smallest / 2, 0.05 * std::abs(x), 1e-6});
}

std::size_t countFree(const FitSpace& space) {
  std::size_t free = 0;
  for (std::size_t i = 0; i < space.start.size(); ++i) free += !space.isFixed(i);
  return free;
}

FitSpace spaceOf(const WholeTask& task, const CauseList& model) {
  FitSpace space;
  space.part = 0;  // steps are as wide as they are to be
  for (const Chosen& one : model) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      const FreeNumber& number = (*task.causes)[one.cause].cause.free[i];
      space.start.push_back(std::clamp(one.x[i], number.lower, number.upper));
      const double begun = space.start.back();
      space.lower.push_back(number.stays ? begun : number.lower);
      space.upper.push_back(number.stays ? begun : number.upper);
      space.step.push_back(stepOf(task, one.cause, i, one.x[i]));
    }
  }
  space.iterations = countFree(space) > 1 ? kIterationsOfSeveral : kIterations;
  return space;
}

// What the measurement differs from these runs of a model by; `own`: the means of as many of the
// stage's model, none where coarse runs are exact.
Eigen::VectorXd residualOf(const WholeData& data, const WholeStage& stage, const WholePool& pool,
                           const Eigen::VectorXd& own) {
  const auto means = meansOf(pool);
  if (own.size() > 0) return stage.raw() - (data.stackMeans(means) - own);
  std::vector<Eigen::VectorXd> difference(data.runs());
  for (std::size_t run = 0; run < data.runs(); ++run) {
    if (means[run].size() > 0) difference[run] = data.measured(run) - means[run];
  }
  return data.stackMeans(difference);
}

// The first number of robots on their feet, whose runs part by chance: a fit by slopes between near
// neighbours, nearly all of it chance, told a gyroscope that exaggerates by 0.35 to by 0.1, where
// it began.
FitPoint lowest(const std::function<Eigen::VectorXd(const std::vector<double>&)>& residual,
                const FitSpace& space) {
  std::map<double, Eigen::VectorXd> seen;
  std::vector<double> at = space.start;
  const auto cost = [&](double x) {
    at[0] = x;
    if (seen.count(x) == 0) seen[x] = residual(at);
    return seen[x].squaredNorm() / 2;
  };
  FitPoint point;
  const double x = lowestAlong(cost, space.start[0], space.lower[0], space.upper[0]);
  point.x = space.start;
  point.x[0] = x;
  point.cost = cost(x);
  point.residual = seen[x];
  return point;
}

// Of the stacked means by one number, from this far on either side of it.
Halves slopeAcross(const WholeTask& task, const CauseList& model, const FitSpace& space,
                   std::size_t number, double width) {
  const std::vector<double> x = numbersOf(model);
  const auto beside = [&](double by) {
    return std::clamp(x[number] + by, space.lower[number], space.upper[number]);
  };
  const auto meansAt = [&](double value) {
    std::vector<double> there = x;
    there[number] = value;
    return task.data->stackHalves(slopeRuns(task, withNumbers(model, there)));
  };
  const double from = beside(-width), to = beside(width);
  return (meansAt(to) - meansAt(from)) * (1 / (to - from));
}

// As wide as it takes to be more than chance, if a stage tells how much that is.
Halves slopeOf(const WholeTask& task, const CauseList& model, std::size_t number,
               const WholeStage* stage) {
  const FitSpace space = spaceOf(task, model);
  if (space.isFixed(number)) {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(task.data->size());
    return {none, none};
  }
  const double most = kWidest * std::abs(numbersOf(model)[number]);
  double width = kBeside * space.step[number];
  Halves slope = slopeAcross(task, model, space, number, width);
  const auto coherence = [&] {
    return slope.through([&](const auto& raw) { return stage->whitenFit(raw); }).coherence();
  };
  while (stage && width < most && coherence() < kCoherent) {
    width = std::min(kWider * width, most);
    slope = slopeAcross(task, model, space, number, width);
  }
  return slope;
}

// 0 beyond these blocks.
Eigen::VectorXd only(Blocks blocks, const WholeData& data, Eigen::VectorXd residual) {
  if (blocks == Blocks::Fit) residual.tail(data.size() - data.fitSize()).setZero();
  if (blocks == Blocks::Held) residual.head(data.fitSize()).setZero();
  return residual;
}

}  // namespace

Eigen::VectorXd simulatedResidual(const WholeTask& task, const WholeStage& stage,
                                  const CauseList& model, Blocks blocks, int jobs) {
  const WholePool pool = fitRuns(task, model, blocks, jobs);
  return only(blocks, *task.data, residualOf(*task.data, stage, pool, stage.coarseMeans()));
}

Eigen::VectorXd residualOfAll(const WholeTask& task, const WholeStage& stage,
                              const CauseList& model) {
  const auto of = [&](Blocks blocks) {
    return simulatedResidual(task, stage, model, blocks, task.jobs);
  };
  if (task.data->hasCoarse()) return of(Blocks::All);
  return of(Blocks::Fit) + of(Blocks::Held);
}

Eigen::VectorXd roughResidual(const WholeTask& task, const WholeStage& stage,
                              const CauseList& model) {
  const WholePool pool = lookRuns(task, model, 1);
  return only(Blocks::Fit, *task.data, residualOf(*task.data, stage, pool, stage.roughMeans()));
}

WholeFit fitModel(const WholeTask& task, const WholeStage& stage, const CauseList& start,
                  int jobs) {
  const auto residual = [&](const std::vector<double>& x) {
    return stage.whitenFit(
        simulatedResidual(task, stage, withNumbers(start, x), Blocks::Fit, jobs));
  };
  FitSpace space = spaceOf(task, start);
  space.slopes = false;
  const FitPoint point = leastSquares(residual, space);
  return {withNumbers(start, point.x), point.residual, {}, {}, point.cost};
}

WholeFit fitLast(const WholeTask& task, const WholeStage& stage, const CauseList& with) {
  const auto modelAt = [&](const std::vector<double>& x) {
    CauseList model = with;
    model.back().x = x;
    return model;
  };
  const auto residual = [&](const std::vector<double>& x) {
    return stage.white(simulatedResidual(task, stage, modelAt(x), Blocks::Fit));
  };
  FitSpace space = spaceOf(task, {with.back()});
  space.slopes = false;
  const bool by_slopes = task.data->hasCoarse() || countFree(space) > 1;
  const FitPoint point = by_slopes ? leastSquares(residual, space) : lowest(residual, space);
  return {modelAt(point.x), point.residual, {}, {}, point.cost};
}

void addJacobian(const WholeTask& task, WholeFit& fit, const WholeStage* stage) {
  const std::size_t numbers = numbersOf(fit.model).size();
  fit.jacobian.resize(task.data->size(), static_cast<Eigen::Index>(numbers));
  fit.chance = fit.jacobian;
  for (std::size_t i = 0; i < numbers; ++i) {
    const Halves slope = slopeOf(task, fit.model, i, stage);
    fit.jacobian.col(static_cast<Eigen::Index>(i)) = slope.mean();
    fit.chance.col(static_cast<Eigen::Index>(i)) = (slope.first - slope.second) / 2;
  }
  Eigen::Index at = 0;
  for (const Chosen& one : fit.model) {
    const auto own = static_cast<Eigen::Index>(one.x.size());
    if (own > 1) fit.chance.middleCols(at, own).setZero();
    at += own;
  }
}

}  // namespace nao::validation
