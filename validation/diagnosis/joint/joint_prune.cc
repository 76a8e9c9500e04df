// Whether causes only cancel each other: each is missed if it goes alone, several together are not.
#include <algorithm>
#include <utility>

#include "validation/diagnosis/joint/joint_search.h"
#include "validation/diagnosis/maths/smaller_models.h"

namespace nao::validation {
namespace {

// Of the threshold: what a smaller model may cost by sensitivities.
constexpr double kWorthTrying = 5;
constexpr int kTried = 2;  // smaller models that are simulated

bool isAmong(const std::vector<std::size_t>& places, std::size_t place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

std::vector<std::size_t> allBut(const std::pair<std::size_t, std::size_t>& gone,
                                std::size_t count) {
  std::vector<std::size_t> kept;
  for (std::size_t place = 0; place < count; ++place) {
    if (place != gone.first && place != gone.second) kept.push_back(place);
  }
  return kept;
}

std::vector<LinearCause> asLinear(const JointModel& found) {
  std::vector<LinearCause> model;
  Eigen::Index column = 0;
  for (const Chosen& one : found.fit().model) {
    const auto count = static_cast<Eigen::Index>(one.x.size());
    LinearCause linear{{},
                       Eigen::Map<const Eigen::VectorXd>(one.x.data(), count),
                       found.causes()[one.cause].linear};
    linear.white.resize(found.data().fitSize(), count);
    for (Eigen::Index i = 0; i < count; ++i, ++column) {
      linear.white.col(i) = found.stage().whitenFit(found.fit().jacobian.col(column));
    }
    model.push_back(std::move(linear));
  }
  return model;
}

// Where the numbers of each cause begin.
std::vector<Eigen::Index> firstColumns(const CauseList& model) {
  std::vector<Eigen::Index> first;
  Eigen::Index columns = 0;
  for (const Chosen& one : model) {
    first.push_back(columns);
    columns += static_cast<Eigen::Index>(one.x.size());
  }
  return first;
}

// The fit without the others, as its sensitivities say.
ModelFit fitWithout(const JointModel& found, const SmallerModel& smaller) {
  const ModelFit& all = found.fit();
  const std::vector<Eigen::Index> first = firstColumns(all.model);
  ModelFit fit;
  fit.jacobian.resize(found.data().size(), smaller.numbers.size());
  fit.chance = fit.jacobian;
  Eigen::Index next = 0;
  for (const std::size_t place : smaller.kept) {
    fit.model.push_back(all.model[place]);
    const Cause& cause = found.causes()[fit.model.back().cause];
    for (std::size_t i = 0; i < cause.free.size(); ++i, ++next) {
      const Eigen::Index column = first[place] + static_cast<Eigen::Index>(i);
      fit.jacobian.col(next) = all.jacobian.col(column);
      fit.chance.col(next) = all.chance.col(column);
      if (i == 0 && cause.beats) continue;
      const FreeNumber& number = cause.free[i];
      fit.model.back().x[i] = std::clamp(smaller.numbers[next], number.lower, number.upper);
    }
  }
  return fit;
}

}  // namespace

bool JointSearch::prune() {
  const std::vector<LinearCause> model = asLinear(model_);
  const Eigen::VectorXd left = stage().white(stage().raw());
  int tried = 0;
  for (const SmallerModel& smaller : smallerModels(model, left, kWorthTrying * model_.critical())) {
    if (ensemble_.spent() || tried++ == kTried) return false;
    if (keepOnly(smaller.kept, fitWithout(model_, smaller))) return true;
  }
  if (model.size() < 3) return false;
  for (const auto& pair : undoneByEachOther(model)) {
    if (ensemble_.spent() || tried++ == kTried) return false;
    const std::vector<std::size_t> kept = allBut(pair, model.size());
    if (keepOnly(kept, fitAnew(kept))) return true;
  }
  return false;
}

// These causes alone, from where they stand.
ModelFit JointSearch::fitAnew(const std::vector<std::size_t>& kept) {
  CauseList model;
  for (const std::size_t place : kept) model.push_back(model_.fit().model[place]);
  return fitFully(ensemble_, data_, stage(), causes_, model, effort_);
}

// Whether nothing is to be found beside these causes either: then the others are none.
bool JointSearch::keepOnly(const std::vector<std::size_t>& kept, const ModelFit& fit) {
  JointModel::Snapshot whole = model_.snapshot();
  model_.enter(fit);
  if (stage().largestGain(stage().white(stage().raw())) > model_.critical()) {
    model_.restore(std::move(whole));
    return false;
  }
  for (std::size_t place = model_.found().size(); place-- > 0;) {
    if (isAmong(kept, place)) continue;
    drop(place, model_.found()[place].gain, "no longer needed beside the others");
  }
  reviewAll();
  return true;
}

}  // namespace nao::validation
