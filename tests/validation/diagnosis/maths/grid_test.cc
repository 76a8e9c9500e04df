#include "validation/diagnosis/maths/grid.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/models.h"

namespace nao::validation {
namespace {

LogSet oneRun() {
  LogSet set;
  set.rate = 100;
  set.joints.resize(1);
  set.joints[0].name = "hinge";
  LogRun run;
  run.motion = "m";
  run.t = {0, 0.012, 0.02, 0.031};
  run.columns["cmd.hinge"] = {1, 2, kUnknown, 3};
  run.columns["q.hinge"] = {0, 0.12, kUnknown, 0.31};
  set.runs.push_back(run);
  return set;
}

TEST(Grid, HoldsCommandsAndDrawsLinesBetweenAngles) {
  const auto model = nao::test::pendulum(1, 0.1);
  LogSet set = oneRun();
  const GriddedMotion motion = griddedMotions(set, *model).front();
  ASSERT_EQ(motion.rows, 4u);
  EXPECT_EQ(motion.runs[0].command.at(toJoint(0)), (std::vector<double>{1, 1, 2, 2}));
  const std::vector<double>& angle = motion.runs[0].angle.at(toJoint(0));
  EXPECT_NEAR(angle[1], 0.1, 1e-12);
  EXPECT_NEAR(angle[3], 0.30, 1e-12);
  set.joints[0].sign = -1;
  set.joints[0].zero = 0.5;
  const GriddedMotion turned = griddedMotions(set, *model).front();
  EXPECT_NEAR(turned.runs[0].angle.at(toJoint(0))[1], 0.4, 1e-12);
}

TEST(Grid, RefusesRunsOfOneMotionThatDiffer) {
  LogSet set = oneRun();
  set.runs.push_back(set.runs[0]);
  set.runs[1].kp_scale = 2;
  EXPECT_THROW(griddedMotions(set, *nao::test::pendulum(1, 0.1)), InputError);
}

TEST(Grid, RefusesAJointThatTheModelDoesNotHave) {
  LogSet set = oneRun();
  set.joints[0].name = "tail";
  EXPECT_THROW(griddedMotions(set, *nao::test::pendulum(1, 0.1)), InputError);
}

// "Same motion": one motion alone may be split by its runs.
TEST(Grid, KeepsRunsOfDifferentPurposeApart) {
  LogSet set = oneRun();
  set.runs.push_back(set.runs[0]);
  set.runs[1].split = Split::Test;
  set.runs[1].t.back() = 0.05;
  const auto motions = griddedMotions(set, *nao::test::pendulum(1, 0.1));
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].rows, 4u);
  EXPECT_EQ(motions[1].rows, 6u);
  EXPECT_EQ(motions[1].split, Split::Test);
  EXPECT_EQ(motions[1].runs.size(), 1u);
}

// Times of a computer's clock would make grids of a hundred gigabytes.
TEST(Grid, RefusesTimesThatDoNotCountFromTheMotionsBegin) {
  LogSet set = oneRun();
  for (double& t : set.runs[0].t) t += 1.7e9;
  EXPECT_THROW(griddedMotions(set, *nao::test::pendulum(1, 0.1)), InputError);
  set = oneRun();
  set.runs[0].t.back() = 1e6;
  EXPECT_THROW(griddedMotions(set, *nao::test::pendulum(1, 0.1)), InputError);
}

}  // namespace
}  // namespace nao::validation
