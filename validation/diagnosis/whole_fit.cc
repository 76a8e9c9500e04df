#include "validation/diagnosis/whole_fit.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/team.h"

namespace nao::validation {
namespace {

// Of a fit: one number moves nearly straight to its place, several along valleys.
constexpr int kIterations = 3, kIterationsOfSeveral = 10;

// How far to either side of a number its column of a jacobian looks, in steps of a fit. Runs of
// robots on their feet part by chance however near their numbers are: over one step that made a
// column a third too long, and numbers were told too sure and too near where they began.
constexpr double kBeside = 4;

// All numbers of a model in one row, and back.
std::vector<double> flat(const WholeModel& model) {
  std::vector<double> x;
  for (const WholeChosen& one : model) x.insert(x.end(), one.x.begin(), one.x.end());
  return x;
}
WholeModel withNumbers(WholeModel model, const std::vector<double>& x) {
  std::size_t at = 0;
  for (WholeChosen& one : model) {
    for (double& number : one.x) number = x[at++];
  }
  return model;
}

double stepOf(const FreeNumber& number, double x) {
  return std::max({number.smallest / 2, 0.05 * std::abs(x), 1e-6});
}

FitSpace spaceOf(const std::vector<PlacedCause>& causes, const WholeModel& model) {
  FitSpace space;
  const bool several = flat(model).size() > 1;
  space.iterations = several ? kIterationsOfSeveral : kIterations;
  for (const WholeChosen& one : model) {
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      const FreeNumber& number = causes[one.cause].cause.free[i];
      space.start.push_back(std::clamp(one.x[i], number.lower, number.upper));
      space.lower.push_back(number.lower);
      space.upper.push_back(number.upper);
      space.step.push_back(stepOf(number, one.x[i]));
    }
  }
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

Eigen::VectorXd fitOnly(const WholeData& data, Eigen::VectorXd residual) {
  residual.tail(data.size() - data.fitSize()).setZero();
  return residual;
}

}  // namespace

Eigen::VectorXd simulatedResidual(const WholeTask& task, const WholeStage& stage,
                                  const WholeModel& model, bool fit_only, int jobs) {
  const WholePool pool = fitRuns(task, model, fit_only, jobs);
  const Eigen::VectorXd all = residualOf(*task.data, stage, pool, stage.coarseMeans());
  return fit_only ? fitOnly(*task.data, all) : all;
}

Eigen::VectorXd roughResidual(const WholeTask& task, const WholeStage& stage,
                              const WholeModel& model) {
  const WholePool pool = lookRuns(task, model, 1);
  return fitOnly(*task.data, residualOf(*task.data, stage, pool, stage.roughMeans()));
}

WholeFit fitModel(const WholeTask& task, const WholeStage& stage, const WholeModel& start,
                  int jobs) {
  const auto residual = [&](const std::vector<double>& x) {
    return stage.whitenFit(simulatedResidual(task, stage, withNumbers(start, x), true, jobs));
  };
  FitSpace space = spaceOf(*task.causes, start);
  space.slopes = false;
  const FitPoint point = leastSquares(residual, space);
  return {withNumbers(start, point.x), point.residual, {}, point.cost};
}

WholeFit fitLast(const WholeTask& task, const WholeStage& stage, const WholeModel& with) {
  const auto modelAt = [&](const std::vector<double>& x) {
    WholeModel model = with;
    model.back().x = x;
    return model;
  };
  const auto residual = [&](const std::vector<double>& x) {
    return stage.white(simulatedResidual(task, stage, modelAt(x), true));
  };
  FitSpace space = spaceOf(*task.causes, {with.back()});
  space.slopes = false;
  const FitPoint point = leastSquares(residual, space);
  return {modelAt(point.x), point.residual, {}, point.cost};
}

Eigen::MatrixXd jacobianOf(const WholeTask& task, const WholeModel& model) {
  const FitSpace space = spaceOf(*task.causes, model);
  const std::vector<double> x = flat(model);
  std::vector<Eigen::VectorXd> means(2 * x.size());
  std::vector<double> at(2 * x.size());
  inParallel(at.size(), task.jobs, [&](std::size_t i) {
    const std::size_t number = i / 2;
    std::vector<double> beside = x;
    beside[number] += (i % 2 == 0 ? -1 : 1) * kBeside * space.step[number];
    beside[number] = std::clamp(beside[number], space.lower[number], space.upper[number]);
    at[i] = beside[number];
    const WholePool pool = fitRuns(task, withNumbers(model, beside), false, 1);
    means[i] = task.data->stackMeans(meansOf(pool));
  });
  Eigen::MatrixXd jacobian(task.data->size(), static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    jacobian.col(static_cast<Eigen::Index>(i)) =
        (means[2 * i + 1] - means[2 * i]) / (at[2 * i + 1] - at[2 * i]);
  }
  return jacobian;
}

}  // namespace nao::validation
