// The part of WholeStage that knows what equal robots, and equal runs, differ by.
#include <algorithm>
#include <cmath>

#include "validation/diagnosis/ensemble/start_offsets.h"
#include "validation/diagnosis/jobs/team.h"
#include "validation/diagnosis/whole/whole_stage.h"

namespace nao::validation {
namespace {

// [SD] How far small differences are carried to be seen beside chance; about as at the joint level.
constexpr double kWidely = 8;

}  // namespace

// One SD of each number that equal robots differ by.
void WholeStage::gatherUndeclared() {
  std::vector<Eigen::VectorXd> spreads;
  if (task_.data->hasCoarse()) {
    simulateDifferences(spreads);
    addLateStarts(spreads);
  } else {
    scaleLooks(spreads);
  }
  undeclared_.resize(task_.data->size(), static_cast<Eigen::Index>(spreads.size()));
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    undeclared_.col(static_cast<Eigen::Index>(i)) = spreads[i];
  }
}

void WholeStage::simulateDifferences(std::vector<Eigen::VectorXd>& spreads) const {
  std::vector<Chosen> small;
  for (std::size_t c = 0; c < task_.causes->size(); ++c) {
    const Cause& cause = (*task_.causes)[c].cause;
    if (cause.spread == 0 || has(model_, c)) continue;
    const std::vector<std::vector<double>> starts = startsOf(cause);
    small.push_back({c, starts.empty() ? std::vector<double>(cause.free.size()) : starts.front()});
    small.back().x[0] = std::min(kWidely * cause.spread, cause.free[0].upper);
  }
  const std::size_t first = spreads.size();
  spreads.resize(first + small.size());
  inParallel(small.size(), task_.jobs, [&](std::size_t i) {
    CauseList with = model_;
    with.push_back(small[i]);
    const Eigen::VectorXd means =
        task_.data->stackMeans(meansOf(fitRuns(task_, with, Blocks::All, 1)));
    const double spread = (*task_.causes)[small[i].cause].cause.spread;
    spreads[first + i] = (means - coarse_means_) * (spread / small[i].x[0]);
  });
}

// Small differences, so of several looks at a cause the first.
void WholeStage::scaleLooks(std::vector<Eigen::VectorXd>& spreads) const {
  for (const WholeLook& one : looks_) {
    const Cause& cause = (*task_.causes)[one.cause].cause;
    if (cause.spread == 0 || one.x[0] != cause.free[0].starts[0]) continue;
    spreads.push_back(one.raw * (cause.spread / one.x[0]));
  }
}

// When a run began is known to start_sd, and the mean of a motion's runs by their number better. Of
// robots on their feet no start is drawn, and what it might explain is left to causes: that took a
// quarter of a weak shoulder.
void WholeStage::addLateStarts(std::vector<Eigen::VectorXd>& directions) const {
  const WholeData& data = *task_.data;
  const Eigen::VectorXd simulated = data.stackMeans(meansOf(pool_));
  for (std::size_t block = 0; task_.noise.start_sd > 0 && block < data.spaces().size(); ++block) {
    const auto runs = static_cast<double>(data.simulator().blocks()[block].runs.size());
    Eigen::VectorXd late = Eigen::VectorXd::Zero(data.size());
    for (std::size_t g = 0; g < data.joints(); ++g) {
      const FeatureGroup& group = data.spaces()[block].groups()[g];
      const Eigen::Index at = data.offsets()[block] + group.offset;
      late.segment(at, group.size) =
          task_.noise.start_sd / std::sqrt(runs) *
          rateBetweenSamples(simulated.segment(at, group.size), group.dt);
    }
    directions.push_back(std::move(late));
  }
}

}  // namespace nao::validation
