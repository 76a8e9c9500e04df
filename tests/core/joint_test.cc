#include "core/joint.h"

#include <gtest/gtest.h>

#include <numeric>

namespace nao {
namespace {

TEST(JointArray, HoldsOneValuePerJoint) {
  JointArray<double> array(3, 0.5);
  array[toJoint(1)] = 2;
  EXPECT_EQ(array.size(), 3u);
  EXPECT_EQ(array[0], 0.5);
  EXPECT_EQ(array[toJoint(1)], 2);
  EXPECT_EQ(std::accumulate(array.begin(), array.end(), 0.0), 3);
}

TEST(JointArray, IsEmptyByDefault) {
  const JointArray<int> array;
  EXPECT_EQ(array.size(), 0u);
  EXPECT_EQ(array.begin(), array.end());
}

TEST(JointArray, CopiesAreValues) {
  JointArray<int> array(2, 1);
  const JointArray<int> copy = array;
  array[0] = 9;
  EXPECT_EQ(copy[0], 1);
}

TEST(JointArrayDeathTest, RefusesMoreThanItCanHold) {
  ::testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EQ(JointArray<int>(kMaxJoints).size(), kMaxJoints);
  EXPECT_DEATH(JointArray<int>(kMaxJoints + 1), "check failed: size <= kMaxJoints");
}

TEST(Joint, IsAnIndex) {
  EXPECT_EQ(index(toJoint(7)), 7u);
  EXPECT_NE(toJoint(7), toJoint(8));
}

}  // namespace
}  // namespace nao
