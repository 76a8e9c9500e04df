#include "validation/diagnosis/whole/whole_scatter.h"

#include <cmath>

#include "validation/diagnosis/ensemble/repeats.h"
#include "validation/diagnosis/ensemble/start_offsets.h"

namespace nao::validation {
namespace {

Eigen::VectorXd meanOf(const std::vector<Eigen::VectorXd>& group) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(group.front().size());
  for (const Eigen::VectorXd& one : group) mean += one;
  return mean / static_cast<double>(group.size());
}

// Of the joints' angles; 0 of other signals.
Eigen::VectorXd rateOf(const WholeData& data, std::size_t block, const Eigen::VectorXd& course) {
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(course.size());
  for (std::size_t g = 0; g < data.joints(); ++g) {
    const FeatureGroup& group = data.spaces()[block].groups()[g];
    rate.segment(group.offset, group.size) =
        rateBetweenSamples(course.segment(group.offset, group.size), group.dt);
  }
  return rate;
}

}  // namespace

Eigen::MatrixXd deviationsOf(const std::vector<std::vector<Eigen::VectorXd>>& groups) {
  std::vector<Eigen::VectorXd> all;
  for (const auto& group : groups) {
    if (group.size() < 2) continue;
    const Eigen::VectorXd mean = meanOf(group);
    // So that the mean square is the variance.
    const auto n = static_cast<double>(group.size());
    for (const Eigen::VectorXd& one : group) all.push_back((one - mean) * std::sqrt(n / (n - 1)));
  }
  if (all.empty()) return {};
  Eigen::MatrixXd columns(all.front().size(), static_cast<Eigen::Index>(all.size()));
  for (std::size_t i = 0; i < all.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = all[i];
  return columns;
}

std::vector<std::vector<Eigen::VectorXd>> simulatedRuns(const WholePool& pool,
                                                        const WholeBlock& block) {
  std::vector<std::vector<Eigen::VectorXd>> groups;
  for (const std::size_t run : block.runs) groups.push_back(pool[run]);
  return groups;
}

Alike startedAlike(const WholeData& data, std::size_t block, std::vector<Eigen::VectorXd> runs) {
  Alike alike{std::move(runs), {}};
  if (alike.runs.size() < 2 || !data.hasCoarse()) return alike;
  const Eigen::VectorXd mean = meanOf(alike.runs);
  const Eigen::VectorXd rate = rateOf(data, block, mean);
  for (Eigen::VectorXd& run : alike.runs) {
    alike.late.push_back(latenessOf(run - mean, rate));
    run += alike.late.back() * rate;
  }
  return alike;
}

WholePool startedAlike(const WholeData& data, WholePool pool) {
  for (std::size_t block = 0; block < data.spaces().size(); ++block) {
    for (const std::size_t run : data.simulator().blocks()[block].runs) {
      pool[run] = startedAlike(data, block, std::move(pool[run])).runs;
    }
  }
  return pool;
}

Alike measuredRuns(const WholeData& data, const WholePool& pool, std::size_t block) {
  const auto means = meansOf(pool);
  std::vector<Eigen::VectorXd> runs, simulated;
  for (const std::size_t run : data.simulator().blocks()[block].runs) {
    if (means[run].size() == 0) continue;
    runs.push_back(data.measured(run));
    simulated.push_back(means[run]);
  }
  Alike alike = startedAlike(data, block, std::move(runs));
  for (std::size_t i = 0; i < simulated.size(); ++i) alike.runs[i] -= simulated[i];
  return alike;
}

}  // namespace nao::validation
