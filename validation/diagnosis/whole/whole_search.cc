#include "validation/diagnosis/whole/whole_search.h"

#include <algorithm>
#include <cmath>

#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/maths/least_squares.h"

namespace nao::validation {
namespace {

constexpr std::size_t kAllRuns = 1000000;
// Of the excess misfit, that a cause must explain at least; as at the joint level.
constexpr double kLeastShare = 0.03;
// 99 % of chi-square with one degree of freedom, maximised over about ten independent looks, half:
// what the threshold would be if the noise were white [nats].
constexpr double kWhiteThreshold = 6;
// Times the noise before, that a cause must leave for its rivals to be compared once more.
constexpr double kLessNoise = 0.8;
// Of what was wrong at first, that a further cause must explain at least: a replay renders a gross
// effect to about a tenth, which leaves a hundredth of its misfit to causes that are none.
constexpr double kLeastOfAll = 0.02;

std::vector<std::size_t> causesOf(const CauseList& model) {
  std::vector<std::size_t> causes;
  for (const Chosen& one : model) causes.push_back(one.cause);
  return causes;
}

}  // namespace

WholeSearch::WholeSearch(const WholeTask& task, const WholeSpread& spread, Progress progress,
                         double false_alarms, std::vector<Provisional> provisional)
    : task_(task),
      progress_(std::move(progress)),
      false_alarms_(false_alarms),
      nominal_(spread),
      spread_(spread),
      provisional_(std::move(provisional)) {}

WholeVerdict WholeSearch::run() {
  enter({});
  misfit_before_ =
      stage_->whiteAll(stage_->raw()).squaredNorm() / static_cast<double>(task_.data->size());
  lookAtProvisional();
  while (static_cast<int>(fit_.model.size()) < task_.effort.most_causes && step()) review();
  settle();
  WholeVerdict verdict;
  judge(verdict);
  describe(verdict);
  return verdict;
}

void WholeSearch::enter(const WholeFit& fit) {
  const bool new_causes = causesOf(fit.model) != causesOf(fit_.model);
  fit_ = fit;
  if (fit_.jacobian.cols() == 0) fit_.jacobian.resize(task_.data->size(), 0);
  learnNoise();
  if (new_causes) learnStepErrors(task_, fit_.model);
  const std::string what = fit_.model.empty() ? "looking at every cause" : "simulating the model";
  tell(what + " and what it shows by chance");
  stage_ = std::make_unique<WholeStage>(task_, fit_.model, fit_.jacobian, stage_.get());
  critical_ = quantile(stage_->nullGains(), 1 - false_alarms_);
  spread_of_gain_ = std::max(1.0, critical_ / kWhiteThreshold);
  for (const std::size_t cause : stage_->notTried()) not_tried_.push_back(labelOf(cause));
  fit_.residual = stage_->whitenFit(simulatedResidual(task_, *stage_, fit_.model, Blocks::Fit));
  fit_.cost = fit_.residual.squaredNorm() / 2;
}

void WholeSearch::learnNoise() {
  spread_ = nominal_;
  if (!fit_.model.empty()) {
    spread_ = fitSpread(*task_.data, settingsOf(*task_.causes, fit_.model), task_.effort.base_runs,
                        task_.jobs);
  }
  task_.noise = spread_.noise;
}

// Fits of few runs leave numbers where their chance is least, and what that leaves of a large cause
// passes for a second one: further than chance goes, steps are taken that many runs bear out.
void WholeSearch::walkOn() {
  for (int i = 0; i < kMostFarSteps; ++i) {
    auto to = farStep(task_, *stage_, fit_);
    if (!to) return;
    WholeFit moved;
    moved.model = std::move(*to);
    addJacobian(task_, moved, stage_.get());
    enter(moved);
  }
}

// The last step, of which the stage knows nothing, is taken once.
void WholeSearch::settle() {
  walkOn();
  refine(task_, *stage_, fit_);
}

bool WholeSearch::step() {
  std::vector<Candidate> ranking = rank();
  preferProvisional(ranking);
  return accept(ranking);
}

bool WholeSearch::accept(const std::vector<Candidate>& ranking) {
  for (const Candidate& candidate : ranking) {
    if (dropped_.count(candidate.cause) > 0) continue;
    const double held_out =
        candidate.gain > critical_ ? heldOut(fit_.model, candidate.fit.model) : 0;
    const std::string reason = objection(candidate, held_out);
    if (!reason.empty()) {
      rejected_.push_back({labelOf(candidate.cause), candidate.gain, reason});
      continue;
    }
    const double noise = task_.noise.torque;
    take(ranking, candidate, held_out);
    if (task_.noise.torque < kLessNoise * noise && !accepted_.back().others.empty()) compareAgain();
    return true;
  }
  return false;
}

// Into the model, as its last cause.
void WholeSearch::take(const std::vector<Candidate>& ranking, const Candidate& one,
                       double held_out) {
  Accepted accepted;
  accepted.gain = one.gain;
  accepted.held_out = std::isnan(held_out) ? 0 : held_out;
  accepted.folds = std::isnan(held_out) ? 0 : 1;
  accepted.folds_better = accepted.folds;
  const double rows = static_cast<double>(one.fit.residual.size());
  accepted.share = one.gain / std::max(1e-9, one.fit.cost + one.gain - rows / 4);
  accepted.rivals = rivalsOf(ranking, one);
  for (const Candidate& other : ranking) {
    if (&other != &one && other.gain > critical_) {
      accepted.others.push_back(other.fit.model.back());
    }
  }
  accepted_.push_back(accepted);
  gained_ += one.gain;
  WholeFit next = one.fit;
  addJacobian(task_, next, stage_.get());
  enter(next);
  walkOn();
}

// The last cause was chosen under a noise that had to stand for what it explains, in which its
// rivals may have drowned: all of them are fitted and compared by what noise is left.
void WholeSearch::compareAgain() {
  tell("comparing again with less noise");
  CauseList less = fit_.model;
  less.pop_back();
  const double before =
      stage_->whitenFit(simulatedResidual(task_, *stage_, less, Blocks::Fit)).squaredNorm() / 2;
  std::vector<Chosen> all = accepted_.back().others;
  all.insert(all.begin(), fit_.model.back());
  std::vector<Candidate> ranking(all.size());
  inParallel(all.size(), task_.jobs, [&](std::size_t i) {
    CauseList model = less;
    model.push_back(all[i]);
    ranking[i] = {all[i].cause, 0, fitModel(task_, *stage_, model)};
    ranking[i].gain = before - ranking[i].fit.cost;
  });
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  for (const Candidate& one : ranking) {
    const double held_out = heldOut(less, one.fit.model);
    if (held_out <= 0 || one.gain <= critical_) continue;
    if (one.cause != all.front().cause) {
      rejected_.push_back({labelOf(all.front().cause), accepted_.back().gain,
                           "replaced by " + labelOf(one.cause) + ", as less noise is left"});
    }
    gained_ -= accepted_.back().gain;
    accepted_.pop_back();
    take(ranking, one, held_out);
    return;
  }
}

// Of the select blocks; not a number if there is none or the cause does nothing there.
double WholeSearch::heldOut(const CauseList& less, const CauseList& model) const {
  const Eigen::Index held = task_.data->size() - task_.data->fitSize();
  if (held == 0) return std::numeric_limits<double>::quiet_NaN();
  const auto tailOf = [&](const CauseList& of) {
    return stage_->whitenAll(residualOfAll(task_, *stage_, of)).tail(held).eval();
  };
  const Eigen::VectorXd before = tailOf(less), after = tailOf(model);
  if ((before - after).norm() < 2) return std::numeric_limits<double>::quiet_NaN();
  return (before.squaredNorm() - after.squaredNorm()) / 2;
}

std::string WholeSearch::objection(const Candidate& candidate, double held_out) const {
  if (candidate.gain <= critical_) return "below the threshold";
  if (held_out <= 0) return "does not predict the motions held back";
  const double excess = fit_.cost - static_cast<double>(fit_.residual.size()) / 4;
  if (excess > 0 && candidate.gain < kLeastShare * excess) return "explains too little";
  if (candidate.gain < kLeastOfAll * gained_) return "explains little beside what was found";
  if (gainByManyRuns(candidate) <= critical_) return "more runs do not bear it out";
  return "";
}

// Few runs of the model may have been unlucky ones, than which those of any cause are better.
double WholeSearch::gainByManyRuns(const Candidate& candidate) const {
  const auto costOf = [&](const Eigen::VectorXd& raw) {
    return stage_->whitenFit(raw).squaredNorm() / 2;
  };
  return costOf(stage_->raw()) - costOf(manyRunsResidual(task_, candidate.fit.model));
}

// Every cause competes again once another one has joined: it must still be needed, and be better
// than those that were fitted beside it.
void WholeSearch::review() {
  for (std::size_t place = 0; place + 1 < fit_.model.size();) {
    CauseList without = fit_.model;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(place));
    tell("reviewing " + placed(fit_.model[place].cause).cause.id);
    WholeFit less = fitModel(task_, *stage_, without);
    const double gain = less.cost - fit_.cost;
    if (gain < critical_) {
      rejected_.push_back({labelOf(fit_.model[place].cause), gain, "no longer needed"});
      dropped_.insert(fit_.model[place].cause);
      accepted_.erase(accepted_.begin() + static_cast<std::ptrdiff_t>(place));
      addJacobian(task_, less, stage_.get());
      enter(less);
      place = 0;
      continue;
    }
    accepted_[place].gain = gain;
    swapOne(place);
    ++place;
  }
}

bool WholeSearch::swapOne(std::size_t place) {
  const std::vector<Chosen> others = accepted_[place].others;
  for (const Chosen& other : others) {
    if (dropped_.count(other.cause) > 0) continue;
    CauseList swapped = fit_.model;
    swapped[place] = other;
    WholeFit fit = fitModel(task_, *stage_, swapped);
    if (fit.cost > fit_.cost - 3 * spread_of_gain_) continue;
    rejected_.push_back({labelOf(fit_.model[place].cause), fit.cost - fit_.cost,
                         "replaced by " + labelOf(other.cause)});
    accepted_[place].rivals.clear();
    addJacobian(task_, fit, stage_.get());
    enter(fit);
    return true;
  }
  return false;
}

void WholeSearch::tell(const std::string& what) const {
  if (progress_) progress_(what);
}

}  // namespace nao::validation
