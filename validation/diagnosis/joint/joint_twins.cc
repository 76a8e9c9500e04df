// One cause in the place of two that imitate it together.
#include <algorithm>
#include <optional>
#include <utility>

#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/joint/one_for_two.h"

namespace nao::validation {
namespace {

constexpr char kOneForTwo[] = "one cause explains what it and another do";

// [nats] Without one of the two no more is left.
double lesserOf(const std::vector<FoundCause>& found, const OneForTwo& one) {
  return std::min(found[one.place].gain, found[one.gone].gain);
}

}  // namespace

// Half the squares that a model leaves, by coarse runs.
double JointSearch::roughlyLeftBy(const CauseList& model) {
  const Halves change = ensemble_.halves(settingsOf(causes_, model), effort_.look_runs, Over::Fit) -
                        stage().quickBase();
  const Eigen::VectorXd left = stage().whitenFit(stage().raw()) - stage().whitenFit(change).mean();
  return left.squaredNorm() / 2;
}

// Fits the best and goes on by exact runs, as what a stop does bends. It need only leave nothing
// else to be found: it is fewer.
bool JointSearch::takesOneForTwo() {
  std::optional<OneForTwo> best;
  double least = 0;
  for (OneForTwo& one : onesForTwo(model_.fit().model, causes_)) {
    if (ensemble_.spent()) return false;
    if (stage().isTaken(one.model.back().cause)) continue;
    const double left = roughlyLeftBy(one.model);
    if (best && left >= least) continue;
    best = std::move(one);
    least = left;
  }
  if (!best || least - model_.byChance().left > lesserOf(model_.found(), *best)) return false;
  JointModel::Snapshot whole = model_.snapshot();
  model_.enter(fitFully(ensemble_, data_, stage(), causes_, best->model, effort_));
  model_.descend(true);
  if (stage().largestGain(stage().white(stage().raw())) > model_.critical()) {
    model_.restore(std::move(whole));
    return false;
  }
  const auto [first, last] = std::minmax(best->place, best->gone);
  for (const std::size_t place : {last, first}) {
    drop(place, model_.found()[place].gain, kOneForTwo);
  }
  model_.found().push_back({best->model.back().cause, 0, 0, {}, {}, {}});
  weighBesideOthers(model_.found().size() - 1);
  reviewAll();
  return true;
}

}  // namespace nao::validation
