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
  if (accepted_.empty() || ensemble_.spent()) return false;
  return accepted_.size() > 2 || half(stage_->white(stage_->raw())) > byChance().most_left;
}

// Puts the best pair in the place of what was found, if it leaves no more than chance does, or,
// where that was two causes or more, far less than they.
bool JointSearch::takesPair(const Stage& start) {
  if (!mayBeTwoOthers()) return false;
  const std::optional<ModelFit> best =
      PairFits(ensemble_, data_, causes_, effort_, start, *stage_).best(firsts_, fit_.model);
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
  if (isOrderly(causes_, fit_.model)) weighEach();  // a review puts what it looks at last
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
