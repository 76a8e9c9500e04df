#pragma once

#include <vector>

#include "validation/diagnosis/whole_data.h"

// How runs of a set, as features, scatter about their means.
namespace nao::validation {

/// Deviations from the mean of each group, a column per run; their mean square is the variance.
/// Groups of one run are left out.
Eigen::MatrixXd deviationsOf(const std::vector<std::vector<Eigen::VectorXd>>& groups);

/// The simulated runs of a block, a group per measured run.
std::vector<std::vector<Eigen::VectorXd>> simulatedRuns(const WholePool& pool,
                                                        const WholeBlock& block);

/// The repeats of a block, each less what the model makes of its own commands.
std::vector<Eigen::VectorXd> measuredRuns(const WholeData& data, const WholePool& pool,
                                          const WholeBlock& block);

}  // namespace nao::validation
