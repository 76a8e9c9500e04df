#include "validation/diagnosis/maths/block_bootstrap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace nao::validation {
namespace {

constexpr int kSets = 400;

// y = 2 u + errors that go on through each block.
struct Line {
  Eigen::MatrixXd jacobian;
  Eigen::VectorXd residual;
  std::vector<SampleBlock> blocks;
};

Line lineWith(std::uint64_t seed, int blocks, int rows) {
  Random random(seed, "line");
  Line line;
  line.jacobian.resize(blocks * rows, 1);
  line.residual.resize(blocks * rows);
  for (int b = 0; b < blocks; ++b) {
    const double slope_error = 0.1 * random.normal();
    for (int i = 0; i < rows; ++i) {
      const double u = std::sin(0.1 * i + b);
      line.jacobian(b * rows + i, 0) = u;
      line.residual[b * rows + i] = slope_error * u;
    }
    line.blocks.push_back({b * rows, rows});
  }
  const Eigen::VectorXd u = line.jacobian.col(0);
  line.residual -= u * (u.dot(line.residual) / u.squaredNorm());  // at its fit
  return line;
}

// 12 logs disagree by 0.1 about the slope, so that their mean is known to 0.1 / sqrt(12).
TEST(BlockBootstrap, IsAsWideAsTheBlocksDisagree) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Line line = lineWith(seed, 12, 100);
    const Eigen::VectorXd weights = Eigen::VectorXd::Ones(line.residual.size());
    const auto moves = bootstrapMoves(line.jacobian, line.residual, weights, line.blocks, kSets, 1);
    sum += quantileOf(moves.col(0), 0.95) - quantileOf(moves.col(0), 0.05);
  }
  const double expected = 2 * 1.645 * 0.1 / std::sqrt(12);
  EXPECT_NEAR(sum / 20, expected, 0.15 * expected);  // a few percent too narrow with 12 blocks
}

TEST(BlockBootstrap, IsTheSameForTheSameSeed) {
  const Line line = lineWith(1, 5, 50);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(line.residual.size());
  const auto again = [&](std::uint64_t seed) {
    return bootstrapMoves(line.jacobian, line.residual, weights, line.blocks, 10, seed);
  };
  EXPECT_EQ(again(3), again(3));
  EXPECT_NE(again(3), again(4));
}

TEST(BlockBootstrap, CutsLogsWhereThereAreFew) {
  const std::vector<SampleBlock> logs{{0, 100}, {100, 55}};
  EXPECT_EQ(blocksOf(logs, 2, 10).size(), 2u);
  const auto parts = blocksOf(logs, 3, 25);
  ASSERT_EQ(parts.size(), 6u);
  Eigen::Index next = 0;
  for (const SampleBlock& part : parts) {
    EXPECT_EQ(part.offset, next);
    next += part.size;
  }
  EXPECT_EQ(next, 155);
}

}  // namespace
}  // namespace nao::validation
