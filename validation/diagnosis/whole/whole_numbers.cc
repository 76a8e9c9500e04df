#include "validation/diagnosis/whole/whole_numbers.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/diagnosis/maths/slope_steps.h"

namespace nao::validation {
namespace {

constexpr double kShortStep = 1;   // [SD] a step that needs no proof
constexpr double kOwnLeft = 0.25;  // of squares

// The steps of the numbers that whitened residuals ask for, by one Gauss-Newton step.
class Steps {
 public:
  Steps(const WholeStage& stage, const ModelSlopes& fit)
      : white_(whitened(stage, fit.jacobian)), steps_(white_, whitened(stage, fit.chance)) {}

  Eigen::VectorXd operator()(const Eigen::VectorXd& residual) const { return steps_(residual); }

  // What each signal of each block adds to the step, once that is taken: a row per signal.
  Eigen::MatrixXd votes(const WholeData& data, Eigen::VectorXd residual) const {
    residual -= white_ * steps_(residual);
    std::vector<Eigen::VectorXd> all;
    for (std::size_t block = 0; block < data.spaces().size(); ++block) {
      for (const FeatureGroup& group : data.spaces()[block].groups()) {
        const Eigen::Index at = data.offsets()[block] + group.offset;
        if (at + group.size > residual.size()) continue;  // not fitted
        Eigen::VectorXd alone = Eigen::VectorXd::Zero(residual.size());
        alone.segment(at, group.size) = residual.segment(at, group.size);
        all.push_back(steps_(alone));
      }
    }
    Eigen::MatrixXd votes(static_cast<Eigen::Index>(all.size()), white_.cols());
    for (std::size_t i = 0; i < all.size(); ++i) votes.row(static_cast<Eigen::Index>(i)) = all[i];
    return votes;
  }

 private:
  static Eigen::MatrixXd whitened(const WholeStage& stage, const Eigen::MatrixXd& columns) {
    Eigen::MatrixXd white(stage.fitSize(), columns.cols());
    for (Eigen::Index i = 0; i < white.cols(); ++i) white.col(i) = stage.whitenFit(columns.col(i));
    return white;
  }

  Eigen::MatrixXd white_;
  SlopeSteps steps_;
};

Eigen::MatrixXd centred(const WholeStage& stage, const Steps& steps) {
  const auto& nulls = stage.nulls();
  const auto sets = static_cast<Eigen::Index>(nulls.size());
  Eigen::MatrixXd draws(steps(stage.whitenFit(stage.raw())).size(), sets);
  for (Eigen::Index set = 0; set < sets; ++set) {
    draws.col(set) = steps(stage.whitenFit(nulls[static_cast<std::size_t>(set)]));
  }
  return draws.colwise() - draws.rowwise().mean();  // all were drawn from one pool
}

// The variance of each number by which signals disagree beyond chance.
Eigen::VectorXd disagreement(const WholeTask& task, const WholeStage& stage, const Steps& steps) {
  const auto squares = [&](const Eigen::VectorXd& raw) -> Eigen::VectorXd {
    return steps.votes(*task.data, stage.whitenFit(raw)).colwise().squaredNorm().transpose();
  };
  Eigen::VectorXd excess = squares(stage.raw());
  for (const Eigen::VectorXd& null : stage.nulls()) {
    excess -= squares(null) / static_cast<double>(stage.nulls().size());
  }
  return excess.cwiseMax(0);
}

// One SD of something in the first number of each cause; 0 of those that shape it.
Eigen::VectorXd inSizes(const WholeTask& task, const CauseList& model,
                        double (Cause::*sd)(double) const) {
  std::vector<double> all;
  for (const Chosen& one : model) {
    all.push_back(((*task.causes)[one.cause].cause.*sd)(one.x[0]));
    all.resize(all.size() + one.x.size() - 1, 0);
  }
  return Eigen::Map<const Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

}  // namespace

Eigen::MatrixXd drawNumbers(const WholeTask& task, const WholeStage& stage,
                            const ModelSlopes& fit) {
  if (fit.jacobian.cols() == 0 || stage.nulls().empty()) return {fit.jacobian.cols(), 0};
  const Steps steps(stage, fit);
  Eigen::MatrixXd draws = centred(stage, steps) * std::sqrt(1 + 1.0 / stage.simulatedPerRun());
  const Eigen::VectorXd spread = inSizes(task, fit.model, &Cause::spreadAt);
  const Eigen::VectorXd law = inSizes(task, fit.model, &Cause::lawErrorAt);
  const Eigen::VectorXd further = (disagreement(task, stage, steps) + law.cwiseAbs2()).cwiseSqrt();
  Random random(1, "numbers of a whole robot");
  for (Eigen::Index set = 0; set < draws.cols(); ++set) {
    for (Eigen::Index i = 0; i < draws.rows(); ++i) {
      draws(i, set) += further[i] * random.normal();
      draws(i, set) += std::sqrt(3.0) * spread[i] * random.uniform(-1, 1);
    }
  }
  return draws;
}

WholeStep stepOf(const WholeTask& task, const WholeStage& stage, const ModelSlopes& fit) {
  WholeStep all{fit.model, 0};
  if (fit.jacobian.cols() == 0 || stage.nulls().size() < 2) return all;
  const Steps steps(stage, fit);
  const Eigen::MatrixXd draws = centred(stage, steps);
  const Eigen::VectorXd step = steps(stage.whitenFit(stage.raw()));
  const Eigen::VectorXd sd =
      (draws.rowwise().squaredNorm() / static_cast<double>(draws.cols() - 1)).cwiseSqrt();
  all.length = step.cwiseQuotient(sd.cwiseMax(1e-12)).cwiseAbs().maxCoeff();
  Eigen::Index at = 0;
  for (Chosen& one : all.to) {
    const std::vector<FreeNumber>& free = (*task.causes)[one.cause].cause.free;
    for (std::size_t i = 0; i < one.x.size(); ++i) {
      one.x[i] = std::clamp(one.x[i] + step[at++], free[i].lower, free[i].upper);
    }
  }
  return all;
}

bool speaksFor(const WholeTask& task, const WholeStage& stage, const Eigen::VectorXd& before,
               const Eigen::VectorXd& after) {
  const Eigen::VectorXd from = stage.whitenFit(before), to = stage.whitenFit(after);
  if (to.squaredNorm() < from.squaredNorm()) return true;
  if (task.data->hasCoarse()) return false;
  const auto own = [&](const Eigen::VectorXd& white) {
    return (white - stage.beside(white)).squaredNorm();
  };
  return own(to) < kOwnLeft * own(from);
}

std::optional<CauseList> farStep(const WholeTask& task, const WholeStage& stage,
                                 const ModelSlopes& fit) {
  WholeStep step = stepOf(task, stage, fit);
  if (step.length <= kByChance) return std::nullopt;
  const StepErrors before = task.data->stepErrors();
  learnStepErrors(task, step.to);
  if (speaksFor(task, stage, stage.raw(), manyRunsResidual(task, step.to))) return step.to;
  task.data->makeUpFor(before);
  return std::nullopt;
}

void refine(const WholeTask& task, const WholeStage& stage, WholeFit& fit) {
  WholeStep step = stepOf(task, stage, fit);
  if (step.length > kByChance) return;
  if (step.length <= kShortStep ||
      speaksFor(task, stage, stage.raw(), manyRunsResidual(task, step.to)))
    fit.model = std::move(step.to);
}

}  // namespace nao::validation
