#include "validation/diagnosis/ensemble.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

// Two motions of two and one rows, four runs each.
TEST(RunPool, HalvesAreOfEvenAndOfOddStreamsAndMakeTheMean) {
  Eigen::MatrixXd longer(2, 4), shorter(1, 4);
  longer << 1, 2, 3, 6, 10, 20, 30, 60;
  shorter << 5, -1, 7, -3;
  RunPool pool{{longer, shorter}, Eigen::Vector3d(3, 30, 2)};
  const Halves halves = pool.halves();
  EXPECT_EQ(halves.first, Eigen::Vector3d(2, 20, 6));
  EXPECT_EQ(halves.second, Eigen::Vector3d(4, 40, -2));
  EXPECT_EQ(halves.mean(), pool.mean);
}

}  // namespace
}  // namespace nao::validation
