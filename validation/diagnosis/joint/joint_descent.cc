// The numbers of a joint's causes by exact runs alone: where these still leave more than chance,
// and in the end.
#include <algorithm>
#include <cmath>
#include <utility>

#include "validation/diagnosis/joint/beat_search.h"
#include "validation/diagnosis/joint/exact_slopes.h"
#include "validation/diagnosis/joint/joint_model.h"

namespace nao::validation {
namespace {

constexpr int kRounds = 5;
constexpr int kShortened = 4;        // a step that leads too far, by half each time
constexpr double kNear = 2;          // [SD of the measured mean] over so short a way slopes hold
constexpr double kWorthAStep = 0.1;  // of what is left beyond chance: less is not worth its runs

}  // namespace

// Coarse runs choose directions badly where a joint sticks or is at a limit, and bend the valley
// that the numbers are in. Of further causes, most of which stand in for a law of no catalogue,
// clocks alone, and what is beside them.
void JointModel::descend(bool every) {
  bool go_on = every;
  for (int round = 0; round < kRounds && !ensemble_.spent(); ++round) {
    const ByChance chance = byChance();
    const double left = stage_->white(stage_->raw()).squaredNorm() / 2;
    if (left < chance.most_left + chance.critical) return;
    std::optional<ModelFit> next;
    if (round == 0) next = nextByClock();
    const bool settles = next.has_value();
    go_on = go_on || settles;
    if (!next && go_on) next = nextByExactRuns();
    if (!next) return;
    Snapshot before = snapshot();
    fit_ = *next;
    ensemble_.learnNoise(settingsOf(causes_, fit_.model));
    enter(stageOf(fit_.model, fit_.jacobian));
    if (stage_->white(stage_->raw()).squaredNorm() / 2 > left) {
      return restore(std::move(before));
    }
    // Slopes beside another clock lead nowhere.
    if (!settles) moveNumbers(fit_, stage_->raw(), *stage_, causes_);
  }
}

// Whether a step that leaves this takes enough of what is more than chance, and what the
// sensitivities so far do not explain.
bool JointModel::isWorthAStep(double left) const {
  const double before = stage_->white(stage_->raw()).squaredNorm() / 2;
  return before - left > kWorthAStep * (before - byChance().left);
}

// None if the newest cause is no clock that beats.
std::optional<ModelFit> JointModel::nextByClock() {
  const Chosen clock = stage_->model().back();
  if (!causes_[clock.cause].beats) return std::nullopt;
  const auto at = [&](double size) {
    CauseList model = stage_->model();
    model.back().x[0] = size;
    return model;
  };
  const double before = leftBy(stage_->model());
  const BeatSize best =
      bestBeside({clock.x[0], before}, beatWidth(data_, clock.x[0]),
                 [&](double size) { return ensemble_.spent() ? before : leftBy(at(size)); });
  if (best.left >= before - critical()) return std::nullopt;
  ModelFit next = fit_;
  next.model = at(best.x);
  return next;
}

// A Gauss-Newton step by exact slopes, as far along it as runs say that it helps; none if nowhere.
std::optional<ModelFit> JointModel::nextByExactRuns() {
  ModelFit here = fit_;
  here.model = stage_->model();
  setExactSlopes(ensemble_, causes_, effort_.slope_runs, *stage_, here);
  ModelFit there = here;
  moveNumbers(there, stage_->raw(), *stage_, causes_);
  const Eigen::VectorXd expected =
      stage_->raw() - here.jacobian * (columnOf(there.model) - columnOf(here.model));
  if (!isWorthAStep(stage_->whitenFit(expected).squaredNorm() / 2)) return std::nullopt;
  const double before = leftBy(here.model);
  const std::vector<double> from = numbersOf(here.model);
  for (int i = 0; i < kShortened; ++i) {
    if (leftBy(there.model) < before - critical()) return there;
    std::vector<double> half = numbersOf(there.model);
    for (std::size_t k = 0; k < half.size(); ++k) half[k] = (from[k] + half[k]) / 2;
    there.model = withNumbers(here.model, half);
  }
  return std::nullopt;
}

void JointModel::refine() {
  left_ = stage_->raw();
  if (fit_.model.empty() || ensemble_.spent()) return;
  fit_.model = stage_->model();  // where its residual was taken
  setExactSlopes(ensemble_, causes_, effort_.slope_runs, *stage_, fit_);
  const Eigen::VectorXd start = columnOf(fit_.model);
  moveNumbers(fit_, stage_->raw(), *stage_, causes_);
  const Eigen::VectorXd change = fit_.jacobian * (columnOf(fit_.model) - start);
  if (stage_->whitenFit(change).norm() < kNear) {
    left_ -= change;
    return;
  }
  const RunPool pool = ensemble_.pool(settingsOf(causes_, fit_.model), effort_.base_runs);
  left_ = data_.mean() - pool.mean;
  const Eigen::VectorXd before = columnOf(fit_.model);
  moveNumbers(fit_, left_, *stage_, causes_);
  left_ -= fit_.jacobian * (columnOf(fit_.model) - before);
}

}  // namespace nao::validation
