#include "validation/log/error_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "core/random.h"

namespace nao::validation {
namespace {

// Two knees that follow late and short; the right one hangs `sag` lower.
LogSet twoKnees(double sag) {
  LogSet set;
  set.name = "knees";
  set.joints = {{"l_knee_y"}, {"r_knee_y"}, {"head_z"}};
  Random random(1, "knees");
  for (int r = 0; r < 6; ++r) {
    LogRun run;
    run.file = "run.csv";
    for (int i = 0; i < 300; ++i) {
      const double t = 0.02 * i;
      run.t.push_back(t);
      for (const char* side : {"l", "r"}) {
        const std::string name = side + std::string("_knee_y");
        run.columns["cmd." + name].push_back(0.5 * std::sin(2 * t));
        run.columns["q." + name].push_back(0.9 * 0.5 * std::sin(2 * (t - 0.1)) +
                                           0.002 * random.normal() - (side[0] == 'r' ? sag : 0.0));
      }
      run.columns["cmd.head_z"].push_back(0);
      run.columns["q.head_z"].push_back(0.01);
    }
    set.runs.push_back(run);
  }
  return set;
}

TEST(ErrorMap, TellsHowLateAndHowFarAJointFollows) {
  const auto joints = errorMapOf(twoKnees(0.05));
  ASSERT_EQ(joints.size(), 3u);
  EXPECT_NEAR(joints[0].lag, 0.1, 0.011);  // rows are 20 ms apart
  EXPECT_NEAR(joints[0].following, 0.9, 0.02);
  EXPECT_NEAR(joints[1].bias - joints[0].bias, 0.05, 1e-3);
  EXPECT_NEAR(joints[2].bias, -0.01, 1e-12);
  EXPECT_EQ(joints[2].lag, 0);
}

TEST(ErrorMap, LocatesTheSideThatHangs) {
  const auto differing = sideDifferences(errorMapOf(twoKnees(0.05)));
  ASSERT_EQ(differing.size(), 1u);
  EXPECT_TRUE(differing[0].differs);
  EXPECT_FALSE(sideDifferences(errorMapOf(twoKnees(0)))[0].differs);
}

TEST(ErrorMap, SaysWhatIsMissing) {
  LogSet set;
  set.name = "nothing";
  EXPECT_THROW(reportErrorMap(set), InputError);
}

}  // namespace
}  // namespace nao::validation
