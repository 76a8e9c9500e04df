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
  return gain / std::max(half(stage.white(stage.raw())) - model_.byChance().left, gain);
}

// Why a candidate may not be named though it fits; empty: nothing against it.
std::string JointSearch::objection(const Candidate& candidate,
                                   const CrossValidation& validation) const {
  const bool unchecked = validation.folds == 0 && candidate.gain > kUnchecked * model_.critical();
  if (!validation.accepted() && !unchecked) return "does not predict data it was not fitted to";
  if (shareOf(stage(), candidate.gain) < kSmallestShare) return "explains under 3 % of the misfit";
  if (model_.isAtEnd({candidate.cause, candidate.x})) return kEndOfRange;
  if (causes_[candidate.cause].one_for_all &&
      model_.others().costOf(candidate.cause, candidate.x[0]) > kUnchecked * model_.critical()) {
    return "there is one for all joints, and others speak against it";
  }
  if (mayBeOffBy(candidate.gain, model_.greatestGain())) return kOffBy;
  return "";
}

// Whether what explains this may be what the law of another that explains so much lacks.
bool JointSearch::mayBeOffBy(double gain, double greatest) const {
  return gain < kLawError * greatest;
}

// Whether a second law of a family may be what the first one's own lacks. But where it frees that
// one of its bound it is needed.
bool JointSearch::mayBeKinsLaw(const Candidate& candidate) const {
  const std::string& family = causes_[candidate.cause].family;
  if (family.empty() || trying_) return false;
  return std::any_of(model_.found().begin(), model_.found().end(), [&](const FoundCause& one) {
    return causes_[one.cause].family == family && candidate.gain < kKinError * one.gain;
  });
}

// How a candidate that may be named predicts what it was not fitted to; of others it notes why not.
std::optional<CrossValidation> JointSearch::validated(const Candidate& candidate) {
  const auto dropped = dropped_.find(candidate.cause);
  if (dropped != dropped_.end() && candidate.gain < dropped->second) return std::nullopt;
  const CrossValidation validation =
      crossValidate(data_, stage(), candidate.fit, candidate.x.size());
  const std::string reason = objection(candidate, validation);
  if (reason.empty()) return validation;
  reject(candidate.cause, candidate.gain, reason);
  return std::nullopt;
}

bool JointSearch::acceptOneOf(std::vector<Candidate>& ranking) {
  const double best = ranking.empty() ? 0 : ranking.front().gain;
  int fitted = 0;
  for (Candidate& candidate : ranking) {
    if (candidate.gain <= model_.critical()) return false;
    if (!candidate.full) {  // all before it may not be named
      if (candidate.gain < kNextBest * best || fitted++ == effort_.finalists) return false;
      if (ensemble_.spent()) return false;
      candidates_.fitFinally(stage(), candidate);
    }
    if (candidate.gain <= model_.critical()) continue;
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
  model_.found().push_back(
      {candidate.cause, candidate.gain, shareOf(stage(), candidate.gain), validation, {}, {}});
  setRivals(model_.found().size() - 1, ranking, stage());
  ensemble_.learnNoise(settingsOf(causes_, candidate.fit.model));
  model_.enter(candidate.fit);
  model_.descend(model_.found().size() == 1);
}

// A joint that sticks or rattles may look explained in coarse steps alone. Of little, chance
// between two ensembles may hide the most.
bool JointSearch::takeIfBorneOut(const Candidate& candidate, const CrossValidation& validation,
                                 const std::vector<Candidate>& ranking) {
  const Eigen::VectorXd raw = stage().raw();
  JointModel::Snapshot before = model_.snapshot();
  take(candidate, validation, ranking);
  const double all = half(stage().whitenFit(raw));
  const double promised = all - half(stage().whitenFit(raw - candidate.fit.change.mean()));
  const double kept = all - half(stage().white(stage().raw()));
  if (kept >= kBorneOut * std::max(0.0, promised)) return true;
  if (promised - kept < kUnchecked * model_.critical()) return true;
  model_.restore(std::move(before));
  reject(candidate.cause, candidate.gain, "runs without approximations do not bear it out");
  return false;
}

// Whether this is what was last said against any.
bool JointSearch::wasRefused(const Candidate& candidate, const char* reason) const {
  return !notes_.rejected.empty() && notes_.rejected.back().cause == causes_[candidate.cause].id &&
         notes_.rejected.back().reason == reason;
}

// One of two causes that act alike, alone, goes as far as it may: only with the other beside it is
// it seen to be what it is. Two such in a row are none.
bool JointSearch::takeIfFreed(const Candidate& candidate, const std::vector<Candidate>& ranking) {
  if (trying_ || !wasRefused(candidate, kEndOfRange)) return false;
  if (mayBeOffBy(candidate.gain, model_.greatestGain())) return false;
  if (static_cast<int>(model_.found().size()) + 2 > effort_.most_causes) return false;
  JointModel::Snapshot before = model_.snapshot();
  const Rejected reason = notes_.rejected.back();
  notes_.rejected.pop_back();
  const std::size_t place = model_.found().size();
  take(candidate, crossValidate(data_, stage(), candidate.fit, candidate.x.size()), ranking);
  trying_ = true;
  const bool freed = step() && !model_.isAtEnd(model_.fit().model[place]);
  trying_ = false;
  if (freed) return true;
  model_.restore(std::move(before));
  notes_.rejected.push_back(reason);
  return false;
}

// A law that is not quite the catalogue's leaves what no second cause is the whole of: one that is,
// and is clearly seen, is no part of it.
bool JointSearch::takeIfNothingIsLeft(const Candidate& candidate,
                                      const std::vector<Candidate>& ranking) {
  if (!wasRefused(candidate, kOffBy) || !model_.remainder().isSome()) return false;
  if (candidate.gain < kClear * model_.critical()) return false;
  JointModel::Snapshot before = model_.snapshot();
  const CrossValidation validation =
      crossValidate(data_, stage(), candidate.fit, candidate.x.size());
  if (!takeIfBorneOut(candidate, validation, ranking)) return false;
  if (!model_.remainder().isSome()) return true;
  model_.restore(std::move(before));
  return false;
}

// What explained more when it was taken, before the numbers of the first came to rest. One that is
// clearly seen was taken because nothing is left beside it.
void JointSearch::dropWhatMayBeOff() {
  for (std::size_t place = model_.found().size(); place-- > 0;) {
    const double gain = model_.found()[place].gain;
    if (model_.found().size() < 2 || ensemble_.spent()) return;
    if (!mayBeOffBy(gain, model_.greatestGain()) || gain > kClear * model_.critical()) continue;
    const std::unique_ptr<Stage> without = model_.stageWithout(place);
    model_.enter(fitFully(ensemble_, data_, *without, causes_, without->model(), effort_));
    drop(place, gain, kOffBy);
  }
}

}  // namespace nao::validation
