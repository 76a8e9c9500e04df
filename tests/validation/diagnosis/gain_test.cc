#include "validation/diagnosis/gain.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/config.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

LogSet setWith(Split split) {
  LogSet set;
  set.name = "mine";
  set.runs.resize(1);
  set.runs[0].split = split;
  return set;
}

TEST(TestRuns, CountHowOftenTheyAreOpened) {
  const TemporaryFolder folder;
  const LogSet set = setWith(Split::Test);
  EXPECT_EQ(openTestRuns(set, folder.path(), "first"), 1);
  EXPECT_EQ(openTestRuns(set, folder.path(), "second"), 2);
}

TEST(TestRuns, ASetWithoutAnyIsNotOpened) {
  const TemporaryFolder folder;
  EXPECT_THROW(openTestRuns(setWith(Split::Fit), folder.path(), "first"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TestRuns, AFolderThatIsNotThereIsAMistakeOfTheUser) {
  EXPECT_THROW(openTestRuns(setWith(Split::Test), "/nowhere/at/all", "first"), InputError);
}

}  // namespace
}  // namespace nao::validation
