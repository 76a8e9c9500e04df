// The part of WholeSearch that fits the causes which promise something, and those handed on by a
// lower level.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/whole/whole_search.h"

namespace nao::validation {
namespace {

// Of a look at a rough cause: sizes at which it is tried, and how many looks of one cause are.
constexpr double kSizes[] = {0.35, 0.5, 0.7, 1, 1.4};
constexpr std::size_t kMostLooks = 6;
// What a fit of one cause must gain for one of all: of the threshold, and of the best one's.
constexpr double kWorth = 0.5, kBehind = 0.2;
constexpr double kMostNulls = 0.9;  // of null sets: what most of them leave

}  // namespace

// Where the fit of a cause may begin: where its best look would be best, half way to there, as a
// gain's effect grows faster than the gain falls, and where it was taken, which may be the other
// sign. A rough cause does nothing below some size and everything beyond another (a stop that is
// not reached, a floor that still holds): all of its looks that promise something, at several
// sizes.
std::vector<Chosen> WholeSearch::beginningsOf(const WholeLook& look, double scale) const {
  std::vector<Chosen> all(3, {look.cause, look.x});
  all[0].x[0] *= scale;
  all[1].x[0] *= scale / 2;
  if (placed(look.cause).cause.linear) return all;
  const Eigen::VectorXd white = stage_->white(stage_->raw());
  std::vector<std::pair<double, const WholeLook*>> promising;
  for (const WholeLook& other : stage_->looks()) {
    if (other.cause == look.cause) promising.push_back({WholeStage::gain(other, white), &other});
  }
  std::stable_sort(promising.begin(), promising.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  if (promising.size() > kMostLooks) promising.resize(kMostLooks);
  for (const auto& [gain, other] : promising) {
    if (!placed(look.cause).cause.together.empty()) {  // are where they may be
      all.push_back({other->cause, other->x});
      continue;
    }
    for (const double part : kSizes) {
      all.push_back({other->cause, other->x});
      all.back().x[0] *= part;
    }
  }
  return all;
}

// The model with the beginning that a few runs like best.
CauseList WholeSearch::bestOf(const std::vector<Chosen>& beginnings) const {
  CauseList best;
  double least = std::numeric_limits<double>::infinity();
  for (const Chosen& beginning : beginnings) {
    CauseList model = fit_.model;
    model.push_back(beginning);
    const double cost = stage_->whitenFit(roughResidual(task_, *stage_, model)).squaredNorm();
    if (cost >= least) continue;
    least = cost;
    best = std::move(model);
  }
  return best;
}

// Of each beginning the newest cause's numbers alone.
std::vector<WholeSearch::Candidate> WholeSearch::fittedAlone(
    const std::vector<CauseList>& beginnings) const {
  const double before = stage_->beside(fit_.residual).squaredNorm() / 2;
  std::vector<Candidate> fitted(beginnings.size());
  inParallel(beginnings.size(), task_.jobs, [&](std::size_t i) {
    fitted[i] = {beginnings[i].back().cause, 0, fitLast(task_, *stage_, beginnings[i])};
    fitted[i].gain = before - fitted[i].fit.cost;
  });
  return fitted;
}

// Fits of all numbers at once cost most of a search: those of the newest alone tell which causes
// are far behind.
std::vector<CauseList> WholeSearch::worthAFit(const std::vector<Candidate>& alone) {
  double most = 0;
  for (const Candidate& one : alone) most = std::max(most, one.gain);
  std::vector<CauseList> kept;
  for (const Candidate& one : alone) {
    const bool worth = one.gain >= std::max(kWorth * critical_, kBehind * most);
    if (worth || provisionalOf(one.cause) != nullptr) {
      kept.push_back(one.fit.model);
    } else {
      rejected_.push_back({labelOf(one.cause), one.gain, "others promise more"});
    }
  }
  return kept;
}

// Of every cause its best look, the best first.
std::vector<WholeSearch::Promise> WholeSearch::promises() const {
  const Eigen::VectorXd white = stage_->white(stage_->raw());
  std::map<std::size_t, Promise> best;
  for (const WholeLook& look : stage_->looks()) {
    double scale = 0;
    const double gain = WholeStage::gain(look, white, &scale);
    if (gain > best[look.cause].gain) best[look.cause] = {gain, scale, &look};
  }
  std::vector<Promise> all;
  for (const auto& [cause, one] : best) {
    if (one.look) all.push_back(one);
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Promise& a, const Promise& b) { return a.gain > b.gain; });
  return all;
}

// Whether the model leaves no more than null sets do: then what promises less than chance may is
// chance, and not worth a fit.
bool WholeSearch::leavesOnlyChance() const {
  if (fit_.model.empty()) return false;
  std::vector<double> nulls;
  for (const Eigen::VectorXd& null : stage_->nulls()) {
    nulls.push_back(stage_->white(null).squaredNorm());
  }
  return stage_->white(stage_->raw()).squaredNorm() <= quantile(nulls, kMostNulls);
}

// By cause, where their fits begin.
std::vector<std::vector<Chosen>> WholeSearch::finalists() {
  const std::vector<Promise> looks = promises();
  const bool chance = leavesOnlyChance();
  double least = looks.empty() ? 0 : std::max(critical_ / 3, 0.1 * looks.front().gain);
  if (chance) least = std::max(least, critical_);
  std::vector<std::vector<Chosen>> all;
  for (const Promise& one : looks) {
    if (one.gain >= least && static_cast<int>(all.size()) < task_.effort.finalists) {
      all.push_back(beginningsOf(*one.look, one.scale));
    } else if (one.gain > critical_ / 3 && provisionalOf(one.look->cause) == nullptr) {
      rejected_.push_back({labelOf(one.look->cause), one.gain,
                           chance ? "below the threshold" : "others promise more"});
    }
  }
  for (const Provisional& one : provisional_) {
    if (has(fit_.model, one.chosen.cause) || dropped_.count(one.chosen.cause) > 0) continue;
    const auto fitted = std::find_if(all.begin(), all.end(), [&](const auto& beginnings) {
      return beginnings.front().cause == one.chosen.cause;
    });
    if (fitted == all.end()) {
      all.push_back({one.chosen});
    } else {
      fitted->push_back(one.chosen);
    }
  }
  return all;
}

// What does nearly the same as one of these elsewhere may promise little by looks of other sizes:
// it begins there, too, either way.
void WholeSearch::addTwins(std::vector<std::vector<Chosen>>& finalists) const {
  const std::vector<std::vector<Chosen>> own = finalists;
  for (const std::vector<Chosen>& beginnings : own) {
    const Chosen& best = beginnings.front();
    for (const std::string& place : placed(best.cause).twins) {
      const std::size_t twin = sameAt(place, best.cause);
      if (twin == best.cause || has(fit_.model, twin) || dropped_.count(twin) > 0) continue;
      const auto known = std::find_if(finalists.begin(), finalists.end(), [&](const auto& other) {
        return other.front().cause == twin;
      });
      auto& of_twin = known == finalists.end() ? finalists.emplace_back() : *known;
      of_twin.push_back({twin, best.x});
      of_twin.push_back({twin, {-best.x[0]}});
    }
  }
}

// The same cause at another place.
std::size_t WholeSearch::sameAt(const std::string& place, std::size_t cause) const {
  for (std::size_t c = 0; c < task_.causes->size(); ++c) {
    if (placed(c).place == place && placed(c).cause.id == placed(cause).cause.id) return c;
  }
  return cause;
}

std::vector<WholeSearch::Candidate> WholeSearch::fittedFully(
    const std::vector<CauseList>& beginnings) const {
  std::vector<Candidate> fitted(beginnings.size());
  inParallel(beginnings.size(), task_.jobs, [&](std::size_t i) {
    fitted[i] = {beginnings[i].back().cause, 0, fitModel(task_, *stage_, beginnings[i])};
    fitted[i].gain = fit_.cost - fitted[i].fit.cost;
  });
  return fitted;
}

std::vector<WholeSearch::Candidate> WholeSearch::rank() {
  auto beginnings = finalists();
  addTwins(beginnings);
  if (!beginnings.empty()) tell("fitting " + std::to_string(beginnings.size()) + " causes");
  if (task_.data->used() > task_.granted) {
    for (const auto& one : beginnings) not_tried_.push_back(labelOf(one.front().cause));
    beginnings.clear();
  }
  std::vector<CauseList> models(beginnings.size());
  inParallel(beginnings.size(), task_.jobs,
             [&](std::size_t i) { models[i] = bestOf(beginnings[i]); });
  std::vector<Candidate> ranking = fittedAlone(models);
  if (!fit_.model.empty()) ranking = fittedFully(worthAFit(ranking));
  std::stable_sort(ranking.begin(), ranking.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
  return ranking;
}

// How far behind the best another may be without being told apart from it [nats].
double WholeSearch::reachOf(const Candidate& best, const Candidate& other) const {
  const double apart = (best.fit.residual - other.fit.residual).norm();
  return std::max(3 * spread_of_gain_, 1.5 * apart * std::sqrt(spread_of_gain_));
}

std::vector<Rival> WholeSearch::rivalsOf(const std::vector<Candidate>& ranking,
                                         const Candidate& best) const {
  std::vector<Rival> rivals;
  const bool preferred = provisionalOf(best.cause) != nullptr;
  for (const Candidate& other : ranking) {
    const double behind = best.gain - other.gain;
    if (&other == &best || other.gain <= critical_ || (behind < 0 && !preferred)) continue;
    if (behind > reachOf(best, other)) continue;
    const PlacedCause& of = placed(other.cause);
    rivals.push_back({of.cause.id, of.cause.effect,
                      of.place == placed(best.cause).place ? "" : of.place,
                      numbersOf(other.fit.model.back()), behind});
  }
  return rivals;
}

// What a lower level named alone comes first where this one can not tell it from its best.
void WholeSearch::preferProvisional(std::vector<Candidate>& ranking) const {
  for (std::size_t i = 1; i < ranking.size(); ++i) {
    const Provisional* one = provisionalOf(ranking[i].cause);
    if (one == nullptr || !one->was.alone || ranking[i].gain <= critical_) continue;
    if (ranking[0].gain - ranking[i].gain > reachOf(ranking[0], ranking[i])) continue;
    std::rotate(ranking.begin(), ranking.begin() + static_cast<std::ptrdiff_t>(i),
                ranking.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return;
  }
}

const Provisional* WholeSearch::provisionalOf(std::size_t cause) const {
  const auto at = std::find_if(provisional_.begin(), provisional_.end(),
                               [&](const Provisional& one) { return one.chosen.cause == cause; });
  return at == provisional_.end() ? nullptr : &*at;
}

// By how much the motions would differ from the nominal model's if a lower level were right.
void WholeSearch::lookAtProvisional() {
  would_show_.resize(provisional_.size());
  inParallel(provisional_.size(), task_.jobs, [&](std::size_t i) {
    const CauseList model{provisional_[i].chosen};
    const Eigen::VectorXd residual =
        stage_->whitenFit(simulatedResidual(task_, *stage_, model, Blocks::Fit));
    would_show_[i] = (residual - fit_.residual).norm();
  });
}

HandedOnFate WholeSearch::fateOf(std::size_t number) const {
  const Provisional& one = provisional_[number];
  HandedOnFate fate{one.was, numbersOf(one.chosen).front(), {}, would_show_[number], ""};
  const std::string label = labelOf(one.chosen.cause);
  for (const Chosen& chosen : fit_.model) {
    if (chosen.cause != one.chosen.cause) continue;
    fate.now = numbersOf(chosen).front();
    fate.outcome = "found here too";
    return fate;
  }
  // If it were so it would gain no more than chance may.
  if (fate.would_show * fate.would_show / 2 < critical_) {
    fate.outcome = "these motions do not tell";
    return fate;
  }
  fate.outcome = "not found here";
  for (const Rejected& other : rejected_) {
    if (other.cause == label) fate.outcome = "not found here: " + other.reason;
  }
  return fate;
}

}  // namespace nao::validation
