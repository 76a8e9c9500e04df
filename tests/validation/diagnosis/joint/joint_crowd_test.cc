#include "validation/diagnosis/joint/joint_crowd.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

constexpr double kUsual = 0.03, kFitted = 0.23;  // [N m]

JointVerdict verdictOf(Verdict said, bool finding = true) {
  JointVerdict verdict;
  verdict.verdict = said;
  verdict.noise = kFitted;
  if (finding) verdict.findings.emplace_back();
  return verdict;
}

// An elbow that sticks with 1.5 N m scattered as under 0.23 N m. In that noise its friction was
// found, but might have been of any size: it was no discrepancy, and nobody looked once more.
TEST(JointCrowd, SearchesOnceMoreWhereNoiseHidesHowLargeACauseIs) {
  JointVerdict sticks = verdictOf(Verdict::NoDiscrepancy);
  sticks.findings[0].small = true;
  EXPECT_TRUE(isLoud(sticks, kFitted, kUsual));
}

TEST(JointCrowd, SearchesOnceMoreWhereNoiseIsNotExplained) {
  EXPECT_TRUE(isLoud(verdictOf(Verdict::Named), kFitted, kUsual));
  EXPECT_TRUE(isLoud(verdictOf(Verdict::Unknown, false), kFitted, kUsual));
  JointVerdict explained = verdictOf(Verdict::Named);
  explained.noise = kUsual;
  EXPECT_FALSE(isLoud(explained, kFitted, kUsual));
}

// Some joints are loud.
TEST(JointCrowd, LeavesAJointWithoutAFindingAsItIs) {
  EXPECT_FALSE(isLoud(verdictOf(Verdict::NoDiscrepancy, false), kFitted, kUsual));
  EXPECT_FALSE(isLoud(verdictOf(Verdict::Unfinished), kFitted, kUsual));
  EXPECT_FALSE(isLoud(verdictOf(Verdict::Named), 2 * kUsual, kUsual));
  EXPECT_FALSE(isLoud(verdictOf(Verdict::Named), kFitted, 0));  // not known
}

}  // namespace
}  // namespace nao::validation
