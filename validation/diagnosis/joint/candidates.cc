#include "validation/diagnosis/joint/candidates.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/joint/beat_search.h"
#include "validation/diagnosis/joint/signature.h"
#include "validation/diagnosis/maths/span.h"

namespace nao::validation {
namespace {

constexpr double kWorthFitting = 0.7;   // of the threshold: what a look must promise
constexpr double kCoarse = 0.002;       // of the misfit: what a fit leaves by its coarse steps
constexpr double kHopeless = 0.03;      // of the best look's gain: less never becomes the best fit
constexpr double kFarBehind = 0.25;     // of the best so far: not worth finer steps than rough ones
constexpr double kClose = 0.06;         // of the best quick gain: fitted fully as well
constexpr double kCloseIfShaped = 0.2;  // where only one of several numbers was fitted so far
// Of what is lacked: by part of a period of a ripple. Three hidden ones were 93 to 99 %, ripples
// that laws of no catalogue begin with 27 to 64.
constexpr double kAllOfIt = 0.9;
constexpr std::size_t kWeighed = 3;
constexpr double kSame = 0.03;             // of the gain: rivals within it are not told apart
constexpr double kSameByExactRuns = 0.01;  // where both were weighed
constexpr double kSameIfWhole = 0.002;     // and the best leaves no more than chance

// The first `count`.
void sortBest(std::vector<Candidate>& ranking, std::size_t count) {
  std::stable_sort(ranking.begin(), ranking.begin() + static_cast<std::ptrdiff_t>(count),
                   [](const Candidate& a, const Candidate& b) { return a.gain > b.gain; });
}
void sortBest(std::vector<Candidate>& ranking) { sortBest(ranking, ranking.size()); }

// Into the ranking, of each cause the best.
void put(const QuickFit& fit, std::vector<Candidate>& ranking) {
  const auto same = std::find_if(ranking.begin(), ranking.end(),
                                 [&](const Candidate& c) { return c.cause == fit.cause; });
  const Candidate candidate{fit.cause, fit.x, fit.gain, false, false, false, {}};
  if (same == ranking.end()) {
    ranking.push_back(candidate);
  } else if (fit.gain > same->gain) {
    *same = candidate;
  }
}

}  // namespace

double reachOf(const Candidate& best, const Candidate& other, double critical) {
  double same = kSame;
  if (best.weighed && other.weighed) same = best.whole ? kSameIfWhole : kSameByExactRuns;
  return std::max(critical, same * best.gain);
}

Candidates::Candidates(const JointSimulator& joint, Ensemble& ensemble, const JointData& data,
                       const std::vector<Cause>& causes, const Effort& effort)
    : joint_(joint), ensemble_(ensemble), data_(data), causes_(causes), effort_(effort) {}

std::vector<Candidate> Candidates::rankedAt(const Stage& stage, const ByChance& chance) {
  std::vector<Candidate> ranking;
  fitQuickly(stage, startsAt(stage, chance.critical, effort_.survivors), ranking);
  complete(stage, chance.critical, effort_.finalists, ranking);
  const double all = stage.white(stage.raw()).squaredNorm() / 2;
  if (ranking.empty() || all - ranking.front().gain <= chance.most_left + kCoarse * all)
    return ranking;
  const bool beats = addBeats(stage, ranking);
  if (addRipple(stage, ranking) || beats) {
    fitFinalists(stage, chance.critical, effort_.finalists, ranking);
  }
  return ranking;
}

std::vector<Candidate> Candidates::rankedAgain(const Stage& stage, double critical,
                                               const Chosen& own) {
  std::vector<QuickFit> starts = startsAt(stage, critical, (effort_.survivors + 1) / 2);
  const auto other = std::remove_if(starts.begin(), starts.end(),
                                    [&](const QuickFit& one) { return one.cause == own.cause; });
  starts.erase(other, starts.end());
  starts.insert(starts.begin(), {own.cause, own.x, 0});
  std::vector<Candidate> ranking;
  fitQuickly(stage, starts, ranking);
  complete(stage, critical, (effort_.finalists + 1) / 2, ranking);
  return ranking;
}

void Candidates::complete(const Stage& stage, double critical, int finalists,
                          std::vector<Candidate>& ranking) {
  addTwins(stage, ranking);
  fitFinalists(stage, critical, finalists, ranking);
}

std::vector<QuickFit> Candidates::startsAt(const Stage& stage, double critical, int most) const {
  const Eigen::VectorXd white = stage.white(stage.raw());
  const double least = std::max(kWorthFitting * critical, kHopeless * stage.largestGain(white));
  return startsFor(stage, causes_, white, least, most);
}

void Candidates::fitQuickly(const Stage& stage, const std::vector<QuickFit>& starts,
                            std::vector<Candidate>& ranking) {
  for (const QuickFit& start : starts) {
    if (ensemble_.spent()) {
      not_tried_.push_back(causes_[start.cause].id);
      continue;
    }
    double least = -std::numeric_limits<double>::infinity();
    for (const Candidate& one : ranking) least = std::max(least, kFarBehind * one.gain);
    put(validation::fitQuickly(ensemble_, stage, causes_, start, effort_, least), ranking);
  }
  sortBest(ranking);
}

// Sizes of clocks, which no look at another size tells of; false if there are none to try.
bool Candidates::addBeats(const Stage& stage, std::vector<Candidate>& ranking) {
  std::vector<QuickFit> starts;
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    if (!causes_[c].beats || stage.isTaken(c)) continue;
    for (const double size : beatingSizes(ensemble_, stage, causes_, c)) {
      starts.push_back({c, {size}, 0});
    }
  }
  fitQuickly(stage, starts, ranking);
  return !starts.empty();
}

// Where the torque that the model lacks ripples; false if it does not.
bool Candidates::addRipple(const Stage& stage, std::vector<Candidate>& ranking) {
  if (ensemble_.spent()) return false;
  const bool alone = stage.model().empty();
  const Signature lacked = lackedAt(joint_, ensemble_, causes_, stage);
  if (!lacked.ripple) return false;
  const double periods = lacked.ripple->periods;
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    if (!causes_[c].ripples || stage.isTaken(c)) continue;
    const FreeNumber& per_turn = causes_[c].free[1];
    const double x = periods - per_turn.neutral;
    if (x < per_turn.lower || x > per_turn.upper) continue;
    if (causes_[c].alone && (!alone || lacked.terms[0].explained < kAllOfIt)) continue;
    fitQuickly(stage, {{c, {lacked.ripple->torque, x, lacked.ripple->phase}, 0}}, ranking);
    return true;
  }
  return false;
}

// What does nearly the same as the best, from its number.
void Candidates::addTwins(const Stage& stage, std::vector<Candidate>& ranking) {
  if (ranking.empty()) return;
  const Candidate best = ranking.front();
  for (const std::string& twin : causes_[best.cause].twins) {
    for (std::size_t c = 0; c < causes_.size(); ++c) {
      if (causes_[c].id != twin || stage.isTaken(c)) continue;
      for (const double x : {best.x[0], -best.x[0]}) {
        if (ensemble_.spent()) return;
        if (x < causes_[c].free[0].lower || x > causes_[c].free[0].upper) continue;
        put(validation::fitQuickly(ensemble_, stage, causes_, {c, {x}, 0}, effort_), ranking);
      }
    }
  }
  sortBest(ranking);
}

void Candidates::fitFinalists(const Stage& stage, double critical, int most,
                              std::vector<Candidate>& ranking) {
  const double best = ranking.empty() ? 0 : ranking.front().gain;
  const double worth = kWorthFitting * critical;
  int fitted = 0;
  for (Candidate& candidate : ranking) {
    if (candidate.gain < worth) break;
    const double close = candidate.x.size() > 1 ? kCloseIfShaped : kClose;
    if (candidate.full || candidate.gain < best - std::max(2 * critical, close * best)) continue;
    if (fitted++ == most || ensemble_.spent()) break;
    fitFinally(stage, candidate);
  }
  sortBest(ranking);
}

void Candidates::fitFinally(const Stage& stage, Candidate& candidate) {
  const QuickFit best =
      reshaped(ensemble_, stage, causes_, {candidate.cause, candidate.x, candidate.gain}, effort_);
  candidate.x = best.x;
  candidate.gain = best.gain;
  CauseList model = stage.model();
  model.push_back({candidate.cause, candidate.x});
  candidate.fit = fitFully(ensemble_, data_, stage, causes_, model, effort_, candidate.gain);
  candidate.gain = candidate.fit.gain;
  candidate.x = candidate.fit.model.back().x;
  candidate.full = true;
}

void Candidates::weigh(const Stage& stage, const ByChance& chance,
                       std::vector<Candidate>& ranking) {
  std::vector<Candidate*> near;
  for (Candidate& candidate : ranking) {
    const Candidate& best = ranking.front();
    if (!candidate.full || near.size() == kWeighed) break;
    if (candidate.gain < best.gain - reachOf(best, candidate, chance.critical)) break;
    near.push_back(&candidate);
  }
  if (near.size() < 2 || near.front()->gain <= chance.critical) return;
  const double before = stage.white(stage.raw()).squaredNorm() / 2;
  for (Candidate* candidate : near) {
    if (ensemble_.spent()) return;
    const double left = leftBy(stage, candidate->fit);
    candidate->gain = before - left;
    candidate->whole = left <= chance.left;
    candidate->x = candidate->fit.model.back().x;
    candidate->weighed = true;
  }
  sortBest(ranking, near.size());
}

// Half the squares of what is really left with this fit, its numbers moved to where that is least.
// Runs of the same streams for every fit: their chance falls out between fits.
double Candidates::leftBy(const Stage& stage, ModelFit& fit) {
  const auto left = [&](int runs) -> Eigen::VectorXd {
    return data_.mean() - ensemble_.pool(settingsOf(causes_, fit.model), runs).mean;
  };
  moveNumbers(fit, left(effort_.brief_runs), stage, causes_);
  const Eigen::VectorXd white = stage.whitenFit(left(effort_.brief_runs));
  Eigen::MatrixXd own(white.size(), fit.jacobian.cols());
  for (Eigen::Index i = 0; i < own.cols(); ++i) own.col(i) = stage.whitenFit(fit.jacobian.col(i));
  return without(orthonormal(own), white).squaredNorm() / 2;
}

}  // namespace nao::validation
