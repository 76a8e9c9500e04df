#include "validation/log/floor_recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/models.h"
#include "validation/log/data_faults.h"

namespace nao::validation {
namespace {

LogSet record(const std::vector<FloorMotion>& motions, std::uint64_t seed) {
  FloorPlan plan;
  plan.model = test::robot("nao_h21_v33");
  plan.extra = {{"process_noise", {}, {}, ""}};
  plan.motions = motions;
  plan.repeats = 1;
  plan.seed = seed;
  return recordOnFloor(plan);
}

TEST(FloorRecording, StandsThroughAllStandingMotions) {
  const LogSet set = record(standingMotions(), 1);
  ASSERT_EQ(set.runs.size(), standingMotions().size());
  EXPECT_FALSE(set.environment.suspended);
  for (const LogRun& run : set.runs) {
    const Column& z = *run.find("gt.base.z");
    const double low = *std::min_element(z.begin(), z.end());
    EXPECT_GT(low, 0.29) << run.motion;
    const bool squats = run.motion != "sway" && run.motion != "arms";
    EXPECT_EQ(low < z.front() - 0.008, squats) << run.motion;
    const Column& pitch = *run.find("imu.ang.y");
    for (const double angle : pitch) ASSERT_NEAR(angle, pitch.front(), 0.05) << run.motion;
  }
}

TEST(FloorRecording, WalksWhereItIsToldAndWritesWhereItWas) {
  const std::vector<FloorMotion> forward{walkingMotions().front()};
  const LogSet set = record(forward, 1);
  const Column& x = *set.runs[0].find("gt.base.x");
  EXPECT_NEAR(x.back() - x.front(), forward[0].walk->x, 0.05);
  EXPECT_FALSE(anyFault(findDataFaults(set, test::robot("nao_h21_v33").get())));
  EXPECT_EQ(set.runs[0].columns, record(forward, 1).runs[0].columns);
  EXPECT_NE(set.runs[0].columns, record(forward, 2).runs[0].columns);
}

}  // namespace
}  // namespace nao::validation
