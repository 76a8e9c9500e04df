#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// Samples that belong together: a log, or a second of one.
struct SampleBlock {
  Eigen::Index offset = 0, size = 0;
};

/// Without repeats nothing tells noise from what the model gets wrong, so that both are the
/// uncertainty: how the numbers of a fit move when its blocks are drawn again with replacement,
/// by one weighted Gauss-Newton step each. Errors that go on through a block stay whole, hence
/// intervals that are as wide as the blocks disagree. A row per drawn set, a column per number.
/// `jacobian` is that of the prediction, `residual` measured less predicted, at the fit.
Eigen::MatrixXd bootstrapMoves(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& residual,
                               const Eigen::VectorXd& weights,
                               const std::vector<SampleBlock>& blocks, int sets,
                               std::uint64_t seed);

/// The q-quantile of one column of bootstrapMoves().
double quantileOf(const Eigen::VectorXd& values, double q);

/// Blocks of whole logs where there are at least `least` of them, else each log cut into parts of
/// about `rows` samples.
std::vector<SampleBlock> blocksOf(const std::vector<SampleBlock>& logs, std::size_t least,
                                  Eigen::Index rows);

}  // namespace nao::validation
