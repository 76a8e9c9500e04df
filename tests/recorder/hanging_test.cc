#include "recorder/hanging.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/models.h"

namespace nao::recorder {
namespace {

using ::testing::HasSubstr;
using validation::LogRun;

// Every cell of both feet bears `each` [N]; the torso leans by `roll` and `pitch` [rad].
LogRun rows(double each, double roll, double pitch) {
  LogRun run;
  run.t = {0, 0.01};
  for (const char* foot : {"L", "R"}) {
    for (const char* cell : {"fl", "fr", "rl", "rr"}) {
      run.columns[std::string("fsr.") + foot + "." + cell] = {each, each};
    }
  }
  run.columns["imu.ang.x"] = {roll, roll};
  run.columns["imu.ang.y"] = {pitch, pitch};
  return run;
}

std::string refusalOf(const LogRun& run) {
  try {
    requireHanging(run, *test::robot("nao_h21_v33"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RequireHanging, TakesARobotThatHangs) {
  EXPECT_EQ(refusalOf(rows(0, 0, 0)), "");
  EXPECT_EQ(refusalOf(rows(0.3, -0.02, 0.05)), "");  // cells that drifted
  EXPECT_EQ(refusalOf(LogRun()), "");                // has no such sensors
}

TEST(RequireHanging, RefusesARobotOnItsFeet) {
  EXPECT_THAT(refusalOf(rows(6, 0, 0)), HasSubstr("feet bear 48.0 N"));
}

TEST(RequireHanging, RefusesARobotThatLeans) {
  EXPECT_THAT(refusalOf(rows(0, 0.5, 0)), HasSubstr("roll is 28.6 degrees"));
  EXPECT_THAT(refusalOf(rows(0, 0, -1.5)), HasSubstr("pitch is -85.9 degrees"));
}

}  // namespace
}  // namespace nao::recorder
