#include "validation/diagnosis/maths/chords.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace nao::validation {
namespace {

// A joint that meets a stop where the size is above 0.05: 1000 SD per unit of size, beside a little
// that grows from the start.
Response stopped(double size) {
  return {size, Eigen::Vector2d(10 * size, 1000 * std::max(0.0, size - 0.05))};
}

TEST(Chords, FindASizeBetweenTwoThatDoNotHelp) {
  const Eigen::VectorXd residual = stopped(0.065).change;
  const std::vector<Response> row{stopped(0), stopped(0.04), stopped(0.05), stopped(0.09)};
  for (const Response& one : row) {
    EXPECT_LE(one.change.dot(residual) - one.change.squaredNorm() / 2, 1);
  }
  const SizeGain best = bestOnChords(row, residual);
  EXPECT_NEAR(best.size, 0.065, 1e-9);
  EXPECT_NEAR(best.gain, residual.squaredNorm() / 2, 1e-9);
}

TEST(Chords, SayNothingOfWhatDoesNotHelp) {
  const SizeGain best =
      bestOnChords({stopped(0), stopped(0.04), stopped(0.09)}, Eigen::Vector2d(-1, -1));
  EXPECT_EQ(best.gain, 0);
}

TEST(Chords, ReachBeyondTwoSizesAsFarAsAsked) {
  const Eigen::VectorXd residual = stopped(0.065).change;
  EXPECT_NEAR(alongChord(stopped(0.06), stopped(0.061), residual, 10), 0.065, 1e-9);
  EXPECT_NEAR(alongChord(stopped(0.06), stopped(0.061), residual, 2), 0.062, 1e-9);
}

}  // namespace
}  // namespace nao::validation
