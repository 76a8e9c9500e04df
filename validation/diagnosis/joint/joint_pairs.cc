// Two causes seen together: a spring and a tilt may imitate a bias and more gravity so well that no
// swap of one of them helps.
#include <algorithm>
#include <array>
#include <utility>

#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/maths/pairs.h"

namespace nao::validation {
namespace {

// Free choices, by four hidden pairs: the true one was first or second of its kind, and left up to
// twice what the first seemed to leave.
constexpr int kMost = 3;  // pairs of a kind that are fitted
constexpr double kFar = 2.5;
constexpr std::size_t kWeighed = 2;      // by exact runs
constexpr double kMuchLess = 0.5;        // of what more than chance was left
constexpr double kRough[] = {0.3, 1.5};  // how far a rough cause is scaled
constexpr char kTogether[] = "explained better by two others together";

// How far a cause that was seen with this number may be scaled.
PairPart partOf(const Cause& cause, double x, Eigen::VectorXd white) {
  if (cause.stop || cause.beats) return {std::move(white), 1, 1};
  const double one = cause.free[0].lower / x, other = cause.free[0].upper / x;
  const double lower = std::min(one, other), upper = std::max(one, other);
  if (cause.linear) return {std::move(white), lower, upper};
  return {std::move(white), std::max(lower, kRough[0]), std::min(upper, kRough[1])};
}

Chosen scaled(Chosen one, double scale) {
  one.x[0] *= scale;
  return one;
}

bool actsOnCommand(const Cause& cause) {
  const sim::EffectType* type = sim::standardEffects().find(cause.effect);
  return type != nullptr && includes(type->acts, sim::Acts::OnCommand);
}

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

bool has(const CauseList& model, std::size_t cause) {
  return std::any_of(model.begin(), model.end(),
                     [&](const Chosen& one) { return one.cause == cause; });
}

bool hasAny(const CauseList& model, const CauseList& of) {
  return std::any_of(of.begin(), of.end(),
                     [&](const Chosen& one) { return has(model, one.cause); });
}

bool hasSame(const CauseList& model, const CauseList& of) {
  return model.size() == of.size() && std::all_of(of.begin(), of.end(), [&](const Chosen& one) {
           return has(model, one.cause);
         });
}

CauseList turned(CauseList model) {
  std::reverse(model.begin(), model.end());
  return model;
}

}  // namespace

// Where something is left, or more than two were needed.
bool JointSearch::mayBeTwoOthers() const {
  if (accepted_.empty() || ensemble_.spent()) return false;
  return accepted_.size() > 2 || half(stage_->white(stage_->raw())) > byChance().most_left;
}

// What explained something alone, at its best, and what was found.
CauseList JointSearch::partsOfPairs() const {
  CauseList parts = fit_.model;
  for (const Chosen& one : firsts_) {
    if (!has(parts, one.cause)) parts.push_back(one);
  }
  return parts;
}

// What each part does alone.
std::vector<PairPart> JointSearch::seenAlone(const Stage& start, const CauseList& parts) {
  std::vector<PairPart> seen;
  for (const Chosen& one : parts) {
    const Halves change =
        ensemble_.roughHalves(settingsOf(causes_, {one}), effort_.look_runs, Over::Fit) -
        start.lookBase();
    seen.push_back(partOf(causes_[one.cause], one.x[0], start.white(change).mean()));
  }
  return seen;
}

// What was seen of each alone favours what was found: as many others have none of that.
std::vector<CauseList> JointSearch::pairsToFit(const Stage& start) {
  const CauseList parts = partsOfPairs();
  std::vector<CauseList> models;
  if (fit_.model.size() == 2 && isOrderly(fit_.model)) models.push_back(turned(fit_.model));
  std::array<int, 2> count{};  // of those without and with what was found
  std::array<double, 2> least{};
  for (const PartPair& pair : pairsOf(seenAlone(start, parts), start.white(start.raw()))) {
    const CauseList model = {scaled(parts[pair.first], pair.first_scale),
                             scaled(parts[pair.second], pair.second_scale)};
    if (hasSame(fit_.model, model)) continue;
    const std::size_t kind = hasAny(fit_.model, model) ? 1 : 0;
    if (count[kind] == 0) least[kind] = pair.left;
    if (count[kind] >= kMost || pair.left > kFar * least[kind]) continue;
    ++count[kind];
    models.push_back(model);
    if (isOrderly(model)) models.push_back(turned(model));
  }
  return models;
}

// Of two that alter the command each may act first.
bool JointSearch::isOrderly(const CauseList& model) const {
  return std::all_of(model.begin(), model.end(),
                     [&](const Chosen& one) { return actsOnCommand(causes_[one.cause]); });
}

// The one that exact runs with its numbers leave least of; none: out of runs.
std::optional<ModelFit> JointSearch::bestPair(const Stage& start) {
  const double all = half(start.white(start.raw()));
  Effort brief = effort_;  // their numbers go on by exact runs
  brief.final_runs = effort_.look_runs;
  std::vector<ModelFit> fits;
  for (const CauseList& pair : pairsToFit(start)) {
    if (ensemble_.spent()) break;
    fits.push_back(fitFully(ensemble_, data_, start, causes_, pair, brief));
    if (all - fits.back().gain <= byChance().most_left) break;
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ModelFit& a, const ModelFit& b) { return a.gain > b.gain; });
  fits.resize(std::min(fits.size(), kWeighed));
  std::optional<ModelFit> best;
  double least = 0;
  for (ModelFit& fit : fits) {
    const RunPool pool = ensemble_.pool(settingsOf(causes_, fit.model), effort_.brief_runs);
    moveNumbers(fit, data_.mean() - pool.mean, start, causes_);
    const double left = leftBy(fit.model);
    if (best && left >= least) continue;
    best = fit;
    least = left;
  }
  return best;
}

// Puts the best pair in the place of what was found, if it leaves no more than chance does, or,
// where that was two causes or more, far less than they.
bool JointSearch::takesPair(const Stage& start) {
  if (!mayBeTwoOthers()) return false;
  const std::optional<ModelFit> best = bestPair(start);
  if (!best) return false;
  const double before = excess(), greatest = greatestGain();
  Snapshot whole = snapshot();
  const std::vector<Rejected> rejected = rejected_;
  const std::map<std::size_t, double> dropped = dropped_;
  enterPair(*best);
  const bool by_chance = half(stage_->white(stage_->raw())) <= byChance().most_left;
  const bool less = whole.accepted.size() > 1 && excess() < kMuchLess * before;
  if ((by_chance || less) && isPairOfCauses(greatest)) {
    forgetRejected(fit_.model);
    for (const Accepted& one : whole.accepted) {
      if (!has(fit_.model, one.cause)) reject(one.cause, one.gain, kTogether);
    }
    return true;
  }
  restore(std::move(whole));
  rejected_ = rejected;
  dropped_ = dropped;
  return false;
}

void JointSearch::forgetRejected(const CauseList& found) {
  const auto found_since = [&](const Rejected& one) {
    return std::any_of(found.begin(), found.end(),
                       [&](const Chosen& chosen) { return causes_[chosen.cause].id == one.cause; });
  };
  rejected_.erase(std::remove_if(rejected_.begin(), rejected_.end(), found_since), rejected_.end());
}

void JointSearch::enterPair(const ModelFit& fit) {
  accepted_.clear();
  for (const Chosen& one : fit.model) accepted_.push_back({one.cause, 0, 0, {}, {}, {}});
  ensemble_.learnNoise(settingsOf(causes_, fit.model));
  enterModel(fit);
  weighEach();
}

void JointSearch::weighEach() {
  for (std::size_t place = 0; place < accepted_.size(); ++place) weighBesideOthers(place);
}

// What a cause of the model explains beside the others, and whether it predicts.
void JointSearch::weighBesideOthers(std::size_t place) {
  const std::unique_ptr<Stage> without = stageWithout(place);
  ModelFit own;
  own.jacobian.resize(data_.size(), fit_.jacobian.cols());
  own.jacobian << without->jacobian(), slopesOf(place);
  const auto halves = [&](const CauseList& model) {
    return ensemble_.halves(settingsOf(causes_, model), effort_.final_runs);
  };
  own.change = halves(stage_->model()) - halves(without->model());
  Accepted& one = accepted_[place];
  one.gain = Explained(without->white(own.change), without->white(without->raw())).gain();
  one.share = shareOf(*without, one.gain);
  one.validation = crossValidate(data_, *without, own, fit_.model[place].x.size());
}

// Whether both may be named, by what speaks against a cause that is found alone, and keep their
// places against all others. `greatest`: what one alone explained [nats]; beside another that
// stands in for it that one explains less.
bool JointSearch::isPairOfCauses(double greatest) {
  const CauseList pair = fit_.model;
  review();
  if (accepted_.size() != 2) return false;
  if (isOrderly(fit_.model)) weighEach();  // a review puts what it looks at last
  for (std::size_t place = 0; place < 2; ++place) {
    const Accepted& one = accepted_[place];
    if (!has(pair, one.cause)) return false;
    const Candidate candidate{one.cause, fit_.model[place].x, one.gain, true, false, false, {}};
    if (one.gain <= critical() || mayBeOffBy(one.gain, greatest)) return false;
    if (mayBeKinsLaw(candidate)) return false;
    if (!objection(*stage_, candidate, one.validation).empty()) return false;
  }
  return true;
}

}  // namespace nao::validation
