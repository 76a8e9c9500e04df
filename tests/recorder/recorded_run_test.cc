#include "recorder/recorded_run.h"

#include <gtest/gtest.h>

namespace nao::recorder {
namespace {

using validation::Column;
using validation::LogRun;

TEST(StartAtCommand, LeavesTheRowBeforeTheFirstChangeAtZero) {
  LogRun run;
  run.t = {0, 0.01, 0.02, 0.03, 0.04};
  run.columns["cmd.HeadYaw"] = {0.5, 0.50001, 0.5, 0.5, 0.7};
  run.columns["cmd.HeadPitch"] = {0, 0, 0, 0.1, 0.2};
  run.columns["q.HeadYaw"] = {1, 2, 3, 4, 5};
  startAtCommand(run);
  ASSERT_EQ(run.t.size(), 3u);
  EXPECT_EQ(run.t.front(), 0);
  EXPECT_NEAR(run.t.back(), 0.02, 1e-12);
  EXPECT_EQ(run.columns["q.HeadYaw"], (Column{3, 4, 5}));
}

TEST(StartAtCommand, LeavesARunWithoutCommandsAsItIs) {
  LogRun run;
  run.t = {0, 0.01};
  run.columns["cmd.HeadYaw"] = {0.5, 0.5};
  startAtCommand(run);
  EXPECT_EQ(run.t.size(), 2u);
}

}  // namespace
}  // namespace nao::recorder
