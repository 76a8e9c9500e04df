#include "validation/diagnosis/whole_scatter.h"

#include <cmath>

namespace nao::validation {

Eigen::MatrixXd deviationsOf(const std::vector<std::vector<Eigen::VectorXd>>& groups) {
  std::vector<Eigen::VectorXd> all;
  for (const auto& group : groups) {
    if (group.size() < 2) continue;
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(group.front().size());
    for (const Eigen::VectorXd& one : group) mean += one;
    mean /= static_cast<double>(group.size());
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

std::vector<Eigen::VectorXd> measuredRuns(const WholeData& data, const WholePool& pool,
                                          const WholeBlock& block) {
  const auto means = meansOf(pool);
  std::vector<Eigen::VectorXd> runs;
  for (const std::size_t run : block.runs) {
    if (means[run].size() > 0) runs.push_back(data.measured(run) - means[run]);
  }
  return runs;
}

}  // namespace nao::validation
