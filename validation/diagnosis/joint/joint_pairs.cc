// Two causes seen together: a spring and a tilt may imitate a bias and more gravity so well that no
// swap of one of them helps.
#include <algorithm>
#include <utility>

#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/joint/pair_fits.h"

namespace nao::validation {
namespace {

constexpr double kMuchLess = 0.5;  // of what more than chance was left: free choice
constexpr char kTogether[] = "explained better by two others together";

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

}  // namespace

// Where something is left, or more than two were needed.
bool JointSearch::mayBeTwoOthers() const {
  if (model_.found().empty() || ensemble_.spent()) return false;
  return model_.found().size() > 2 ||
         half(stage().white(stage().raw())) > model_.byChance().most_left;
}

// Puts the best pair in the place of what was found, if it leaves no more than chance does, or,
// where that was two causes or more, far less than they.
bool JointSearch::takesPair(const Stage& start) {
  if (!mayBeTwoOthers()) return false;
  const std::optional<ModelFit> best = PairFits(ensemble_, data_, causes_, effort_, start, stage())
                                           .best(firsts_, model_.fit().model);
  if (!best) return false;
  const double before = model_.excess(), greatest = model_.greatestGain();
  JointModel::Snapshot whole = model_.snapshot();
  const std::vector<Rejected> rejected = notes_.rejected;
  const std::map<std::size_t, double> dropped = dropped_;
  enterPair(*best);
  const bool by_chance = half(stage().white(stage().raw())) <= model_.byChance().most_left;
  const bool less = whole.found.size() > 1 && model_.excess() < kMuchLess * before;
  if ((by_chance || less) && isPairOfCauses(greatest)) {
    forgetRejected(model_.fit().model);
    for (const FoundCause& one : whole.found) {
      if (!has(model_.fit().model, one.cause)) reject(one.cause, one.gain, kTogether);
    }
    return true;
  }
  model_.restore(std::move(whole));
  notes_.rejected = rejected;
  dropped_ = dropped;
  return false;
}

void JointSearch::forgetRejected(const CauseList& found) {
  const auto found_since = [&](const Rejected& one) {
    return std::any_of(found.begin(), found.end(),
                       [&](const Chosen& chosen) { return causes_[chosen.cause].id == one.cause; });
  };
  notes_.rejected.erase(std::remove_if(notes_.rejected.begin(), notes_.rejected.end(), found_since),
                        notes_.rejected.end());
}

void JointSearch::enterPair(const ModelFit& fit) {
  model_.found().clear();
  for (const Chosen& one : fit.model) model_.found().push_back({one.cause, 0, 0, {}, {}, {}});
  ensemble_.learnNoise(settingsOf(causes_, fit.model));
  model_.enter(fit);
  weighEach();
}

void JointSearch::weighEach() {
  for (std::size_t place = 0; place < model_.found().size(); ++place) weighBesideOthers(place);
}

// What a cause of the model explains beside the others, and whether it predicts.
void JointSearch::weighBesideOthers(std::size_t place) {
  const std::unique_ptr<Stage> without = model_.stageWithout(place);
  ModelFit own;
  own.jacobian.resize(data_.size(), model_.fit().jacobian.cols());
  own.jacobian << without->jacobian(), model_.slopesOf(place);
  const auto halves = [&](const CauseList& model) {
    return ensemble_.halves(settingsOf(causes_, model), effort_.final_runs);
  };
  own.change = halves(stage().model()) - halves(without->model());
  FoundCause& one = model_.found()[place];
  one.gain = Explained(without->white(own.change), without->white(without->raw())).gain();
  one.share = shareOf(*without, one.gain);
  one.validation = crossValidate(data_, *without, own, model_.fit().model[place].x.size());
}

// Whether both may be named, by what speaks against a cause that is found alone, and keep their
// places against all others. `greatest`: what one alone explained [nats]; beside another that
// stands in for it that one explains less.
bool JointSearch::isPairOfCauses(double greatest) {
  const CauseList pair = model_.fit().model;
  review();
  if (model_.found().size() != 2) return false;
  if (isOrderly(causes_, model_.fit().model)) weighEach();  // a review puts what it looks at last
  for (std::size_t place = 0; place < 2; ++place) {
    const FoundCause& one = model_.found()[place];
    if (!has(pair, one.cause)) return false;
    const Candidate candidate{one.cause, model_.fit().model[place].x, one.gain, true, false, false,
                              {}};
    if (one.gain <= model_.critical() || mayBeOffBy(one.gain, greatest)) return false;
    if (mayBeKinsLaw(candidate)) return false;
    if (!objection(candidate, one.validation).empty()) return false;
  }
  return true;
}

}  // namespace nao::validation
