#pragma once

#include <vector>

#include "validation/diagnosis/whole/whole_data.h"

// How runs of a set, as features, scatter about their means.
namespace nao::validation {

/// Deviations from the mean of each group, a column per run; their mean square is the variance.
/// Groups of one run are left out.
Eigen::MatrixXd deviationsOf(const std::vector<std::vector<Eigen::VectorXd>>& groups);

/// Runs of limbs that hang, as features, moved in time to where each is nearest to their mean. What
/// runs differ by as they come late is a number of its own, and no noise. Others stay as they are,
/// as no start of theirs is drawn.
struct Alike {
  std::vector<Eigen::VectorXd> runs;
  std::vector<double> late;  // [s] by which each came later than their mean
};
Alike startedAlike(const WholeData& data, std::size_t block, std::vector<Eigen::VectorXd> runs);

/// All simulated runs of each measured one.
WholePool startedAlike(const WholeData& data, WholePool pool);

/// The simulated runs of a block, a group per measured run.
std::vector<std::vector<Eigen::VectorXd>> simulatedRuns(const WholePool& pool,
                                                        const WholeBlock& block);

/// The repeats of a block, started alike, each less what the model makes of its own commands.
Alike measuredRuns(const WholeData& data, const WholePool& pool, std::size_t block);

}  // namespace nao::validation
