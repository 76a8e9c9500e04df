#include "validation/diagnosis/replay/replay.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

// Two SDs that every sample of a run is made of: what mirrored runs have the other way round, and
// what is each run's own.
constexpr double kMirrored = 0.8, kOwn = 0.6;
constexpr Eigen::Index kSamples = 20000;  // a mean of squares of as many is known to 1 %

std::vector<Eigen::MatrixXd> pairedRuns(std::size_t count) {
  Random random(1, "paired runs");
  std::vector<Eigen::MatrixXd> runs(count, Eigen::MatrixXd(kSamples, 1));
  for (Eigen::Index k = 0; k < kSamples; ++k) {
    for (std::size_t i = 0; i < count; i += i % 4 == 1 ? 3 : 1) {
      const double shared = kMirrored * random.normal();
      runs[i](k) = 1 + shared + kOwn * random.normal();
      runs[i + 2](k) = 1 - shared + kOwn * random.normal();
    }
  }
  return runs;
}

TEST(RunSpread, OfMirroredPairsIsThatOfOneRunAndOfTheirMean) {
  for (const std::size_t count : {std::size_t{4}, std::size_t{8}, std::size_t{16}}) {
    const RunSpread spread = spreadOfPairs(pairedRuns(count), 0);
    const double of_one = kMirrored * kMirrored + kOwn * kOwn;
    const double of_mean = kOwn * kOwn / static_cast<double>(count);
    EXPECT_NEAR(spread.variance.mean(), of_one, 0.03 * of_one) << count;
    EXPECT_NEAR(spread.of_mean.mean(), of_mean, 0.03 * of_mean) << count;
    const double squares = (spread.mean.array() - 1).square().mean();
    EXPECT_NEAR(squares, of_mean, 0.03 * of_mean) << count;
  }
}

}  // namespace
}  // namespace nao::validation
