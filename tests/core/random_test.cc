#include "core/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao {
namespace {

// From the definition (FNV-1a of the name, SplitMix64, xoshiro256++, top 53 bits), worked out by
// another program.
TEST(Random, GivesTheSameNumbersOnEveryMachine) {
  Random plain(1);
  EXPECT_EQ(plain.uniform(), 0.058013471003928174);
  EXPECT_EQ(plain.uniform(), 0.8146445926693048);
  Random imu(1, "imu");
  EXPECT_EQ(imu.uniform(), 0.8361481017168623);
  EXPECT_EQ(imu.uniform(), 0.007757904108505076);
  EXPECT_EQ(Random(2, "imu").uniform(), 0.952390647665165);
}

// Logarithm and cosine may differ in the last bit from one C library to the next.
TEST(Random, NormalIsBoxAndMuller) {
  Random random(1, "imu");
  EXPECT_NEAR(random.normal(), 1.8997357761858782, 1e-14);
  EXPECT_NEAR(random.normal(), 0.09267479431296019, 1e-14);
}

TEST(Random, StreamsOfDifferentNamesDiffer) {
  EXPECT_NE(Random(1, "left").uniform(), Random(1, "right").uniform());
  EXPECT_NE(Random(1, "left").uniform(), Random(2, "left").uniform());
}

TEST(Random, UniformFillsItsRange) {
  Random random(3);
  double sum = 0;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.uniform(-2, 4);
    ASSERT_GE(x, -2);
    ASSERT_LT(x, 4);
    sum += x;
  }
  EXPECT_NEAR(sum / kCount, 1, 4 * 6 / std::sqrt(12.0 * kCount));  // four standard errors
}

TEST(Random, NormalHasMeanZeroAndDeviationOne) {
  Random random(4);
  double sum = 0;
  double squares = 0;
  constexpr int kCount = 10000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kCount, 0, 4 / std::sqrt(1.0 * kCount));  // four standard errors
  EXPECT_NEAR(squares / kCount, 1, 4 * std::sqrt(2.0 / kCount));
}

TEST(Random, TheOtherOfAPairMirrorsIt) {
  Random first(5, "torque"), other(5, "torque", Random::Pair::Mirrored);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(other.normal(), -first.normal());
    const double a = first.uniform(-2, 4), b = other.uniform(-2, 4);
    EXPECT_NEAR(a + b, 2, 1e-14);
    EXPECT_LT(b, 4);
  }
}

}  // namespace
}  // namespace nao
