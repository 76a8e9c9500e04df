#include "validation/log/growing_set.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

LogSet emptySet() {
  LogSet set;
  set.name = "grows";
  set.robot = "nao_h21_v33";
  set.rate = 100;
  set.clock = {"robot", "executed", "measured"};
  set.joints.emplace_back();
  set.joints.back().name = "HeadYaw";
  return set;
}

LogRun makeRun(int repeat) {
  LogRun run;
  run.file = "run_tones_" + std::to_string(repeat) + ".csv";
  run.motion = "tones";
  run.repeat = repeat;
  run.t = {0, 0.01};
  run.columns["q.HeadYaw"] = {0.25 * repeat, 0.5};
  return run;
}

TEST(GrowingSet, IsWholeAfterEveryRun) {
  const TemporaryFolder folder;
  const std::string place = folder.path() + "/new/set";
  GrowingSet growing(emptySet(), place);
  for (int repeat = 0; repeat < 3; ++repeat) {
    growing.add(makeRun(repeat));
    const LogSet back = readLogSet(place);
    ASSERT_EQ(back.runs.size(), static_cast<std::size_t>(repeat) + 1);
    EXPECT_EQ(back.runs.back().columns, makeRun(repeat).columns);
  }
  EXPECT_TRUE(growing.set().runs.back().t.empty());  // on disk, not in memory
}

TEST(GrowingSet, DoesNotWriteOverAnother) {
  const TemporaryFolder folder;
  GrowingSet(emptySet(), folder.path()).add(makeRun(0));
  EXPECT_THROW(requireNoSet(folder.path()), InputError);
  EXPECT_THROW(GrowingSet(emptySet(), folder.path()), InputError);
  EXPECT_EQ(readLogSet(folder.path()).runs.size(), 1u);
}

TEST(GrowingSet, StaysAsItWasIfARunCanNotBeWritten) {
  const TemporaryFolder folder;
  GrowingSet growing(emptySet(), folder.path());
  growing.add(makeRun(0));
  std::filesystem::create_directory(folder.path() + "/" + makeRun(1).file);
  EXPECT_THROW(growing.add(makeRun(1)), InputError);
  growing.add(makeRun(2));
  const LogSet back = readLogSet(folder.path());
  ASSERT_EQ(back.runs.size(), 2u);
  EXPECT_EQ(back.runs[1].repeat, 2);
}

}  // namespace
}  // namespace nao::validation
