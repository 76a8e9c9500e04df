// Which candidates may be named, and what becomes of the model with one of them.
#include <algorithm>
#include <utility>

#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {
namespace {

constexpr double kSmallestShare = 0.03;  // of the excess misfit, less is not worth a name
constexpr double kNextBest = 0.4;        // of the best gain: tried if the best may not be named
// Of what the greatest cause explains: the law that a robot follows is only like that of the
// catalogue, and null sets, made by the latter, know nothing of the difference. This is a tenth of
// the first one's response. A false friction beside a rate limit by another law explained 0.8 % of
// what the limit does, and left something. Such seconds are named where nothing is left.
constexpr double kLawError = 0.01;
// Of what the greatest of its own family does: where that one's law is another, this one is the
// likeliest to explain the difference. False seconds beside hidden frictions of other laws
// explained 0.7 to 2.2 % as much as the first, of two that were hidden 52 and 83 %.
constexpr double kKinError = 0.05;
constexpr double kUnchecked = 3;  // of the threshold: where it acts too briefly for any fold
// Of the threshold: what explains so much is not there by chance of a remainder just above its own.
// Of three that were hidden beside a hundred times as much the least was 12.
constexpr double kClear = 8;
constexpr double kBorneOut = 0.5;  // of what a fit promises, by exact runs: free choice
constexpr char kOffBy[] = "explains no more than what was found may itself be off by";
constexpr char kEndOfRange[] = "fits best at the end of its range";

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

}  // namespace

double JointSearch::shareOf(const Stage& stage, double gain) const {
  return gain / std::max(half(stage.white(stage.raw())) - byChance().left, gain);
}

// Why a candidate may not be named though it fits; empty: nothing against it.
std::string JointSearch::objection(const Stage& stage, const Candidate& candidate,
                                   const CrossValidation& validation) const {
  const bool unchecked = validation.folds == 0 && candidate.gain > kUnchecked * critical();
  if (!validation.accepted() && !unchecked) return "does not predict data it was not fitted to";
  if (shareOf(stage, candidate.gain) < kSmallestShare) return "explains under 3 % of the misfit";
  if (isAtEnd({candidate.cause, candidate.x})) return kEndOfRange;
  if (causes_[candidate.cause].one_for_all &&
      others_.costOf(candidate.cause, candidate.x[0]) > kUnchecked * critical()) {
    return "there is one for all joints, and others speak against it";
  }
  if (mayBeOffBy(candidate.gain, greatestGain())) return kOffBy;
  return "";
}

// Whether what explains this may be what the law of another that explains so much lacks.
bool JointSearch::mayBeOffBy(double gain, double greatest) const {
  return gain < kLawError * greatest;
}

double JointSearch::greatestGain() const {
  double greatest = std::max(0.0, given_gain_);
  for (const Accepted& one : accepted_) greatest = std::max(greatest, one.gain);
  return greatest;
}

// Whether a second law of a family may be what the first one's own lacks. But where it frees that
// one of its bound it is needed.
bool JointSearch::mayBeKinsLaw(const Candidate& candidate) const {
  const std::string& family = causes_[candidate.cause].family;
  if (family.empty() || trying_) return false;
  return std::any_of(accepted_.begin(), accepted_.end(), [&](const Accepted& one) {
    return causes_[one.cause].family == family && candidate.gain < kKinError * one.gain;
  });
}

bool JointSearch::isAtEnd(const Chosen& one) const {
  const FreeNumber& size = causes_[one.cause].free[0];
  const double margin = 1e-6 * (size.upper - size.lower);
  const bool above = one.x[0] > size.upper - margin && !causes_[one.cause].whole;
  return above || one.x[0] < size.lower + margin;
}

// How a candidate that may be named predicts what it was not fitted to; of others it notes why not.
std::optional<CrossValidation> JointSearch::validated(const Candidate& candidate) {
  const auto dropped = dropped_.find(candidate.cause);
  if (dropped != dropped_.end() && candidate.gain < dropped->second) return std::nullopt;
  const CrossValidation validation =
      crossValidate(data_, *stage_, candidate.fit, candidate.x.size());
  const std::string reason = objection(*stage_, candidate, validation);
  if (reason.empty()) return validation;
  reject(candidate.cause, candidate.gain, reason);
  return std::nullopt;
}

bool JointSearch::acceptOneOf(std::vector<Candidate>& ranking) {
  const double best = ranking.empty() ? 0 : ranking.front().gain;
  int fitted = 0;
  for (Candidate& candidate : ranking) {
    if (candidate.gain <= critical()) return false;
    if (!candidate.full) {  // all before it may not be named
      if (candidate.gain < kNextBest * best || fitted++ == effort_.finalists) return false;
      if (ensemble_.spent()) return false;
      candidates_.fitFinally(*stage_, candidate);
    }
    if (candidate.gain <= critical()) continue;
    if (mayBeKinsLaw(candidate)) {  // of which the others explain less
      reject(candidate.cause, candidate.gain, kOffBy);
      return false;
    }
    const auto validation = validated(candidate);
    if (validation && takeIfBorneOut(candidate, *validation, ranking)) return true;
    if (validation) continue;
    if (takeIfFreed(candidate, ranking) || takeIfNothingIsLeft(candidate, ranking)) return true;
  }
  return false;
}

void JointSearch::take(const Candidate& candidate, const CrossValidation& validation,
                       const std::vector<Candidate>& ranking) {
  accepted_.push_back(
      {candidate.cause, candidate.gain, shareOf(*stage_, candidate.gain), validation, {}, {}});
  setRivals(accepted_.size() - 1, ranking, *stage_);
  ensemble_.learnNoise(settingsOf(causes_, candidate.fit.model));
  enterModel(candidate.fit);
  descend();
}

// A joint that sticks or rattles may look explained in coarse steps alone. Of little, chance
// between two ensembles may hide the most.
bool JointSearch::takeIfBorneOut(const Candidate& candidate, const CrossValidation& validation,
                                 const std::vector<Candidate>& ranking) {
  const Eigen::VectorXd raw = stage_->raw();
  Snapshot before = snapshot();
  take(candidate, validation, ranking);
  const double all = half(stage_->whitenFit(raw));
  const double promised = all - half(stage_->whitenFit(raw - candidate.fit.change.mean()));
  const double kept = all - half(stage_->white(stage_->raw()));
  if (kept >= kBorneOut * std::max(0.0, promised)) return true;
  if (promised - kept < kUnchecked * critical()) return true;
  restore(std::move(before));
  reject(candidate.cause, candidate.gain, "runs without approximations do not bear it out");
  return false;
}

// Whether this is what was last said against any.
bool JointSearch::wasRefused(const Candidate& candidate, const char* reason) const {
  return !rejected_.empty() && rejected_.back().cause == causes_[candidate.cause].id &&
         rejected_.back().reason == reason;
}

// One of two causes that act alike, alone, goes as far as it may: only with the other beside it is
// it seen to be what it is. Two such in a row are none.
bool JointSearch::takeIfFreed(const Candidate& candidate, const std::vector<Candidate>& ranking) {
  if (trying_ || !wasRefused(candidate, kEndOfRange)) return false;
  if (mayBeOffBy(candidate.gain, greatestGain())) return false;
  if (static_cast<int>(accepted_.size()) + 2 > effort_.most_causes) return false;
  Snapshot before = snapshot();
  const Rejected reason = rejected_.back();
  rejected_.pop_back();
  const std::size_t place = accepted_.size();
  take(candidate, crossValidate(data_, *stage_, candidate.fit, candidate.x.size()), ranking);
  trying_ = true;
  const bool freed = step() && !isAtEnd(fit_.model[place]);
  trying_ = false;
  if (freed) return true;
  restore(std::move(before));
  rejected_.push_back(reason);
  return false;
}

// A law that is not quite the catalogue's leaves what no second cause is the whole of: one that is,
// and is clearly seen, is no part of it.
bool JointSearch::takeIfNothingIsLeft(const Candidate& candidate,
                                      const std::vector<Candidate>& ranking) {
  if (!wasRefused(candidate, kOffBy) || !remainder().isSome()) return false;
  if (candidate.gain < kClear * critical()) return false;
  Snapshot before = snapshot();
  const CrossValidation validation =
      crossValidate(data_, *stage_, candidate.fit, candidate.x.size());
  if (!takeIfBorneOut(candidate, validation, ranking)) return false;
  if (!remainder().isSome()) return true;
  restore(std::move(before));
  return false;
}

JointSearch::Snapshot JointSearch::snapshot() const {
  return {std::make_unique<Stage>(*stage_), fit_, nulls_, accepted_, ensemble_.noise()};
}

void JointSearch::restore(Snapshot before) {
  stage_ = std::move(before.stage);
  fit_ = std::move(before.fit);
  nulls_ = std::move(before.nulls);
  accepted_ = std::move(before.accepted);
  ensemble_.setNoise(before.noise);
}

}  // namespace nao::validation
