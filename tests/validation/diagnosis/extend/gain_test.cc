#include "validation/diagnosis/extend/gain.h"

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
  requireOpenable(set, folder.path());
  EXPECT_EQ(countTestOpenings(folder.path()), 0);
  openTestRuns(set, folder.path(), "first");
  EXPECT_EQ(countTestOpenings(folder.path()), 1);
  openTestRuns(set, folder.path(), "second");
  EXPECT_EQ(countTestOpenings(folder.path()), 2);
}

TEST(TestRuns, ASetWithoutAnyIsNotOpened) {
  const TemporaryFolder folder;
  EXPECT_THROW(requireOpenable(setWith(Split::Fit), folder.path()), InputError);
  EXPECT_THROW(openTestRuns(setWith(Split::Fit), folder.path(), "first"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(TestRuns, AFolderThatIsNotThereIsAMistakeOfTheUser) {
  EXPECT_THROW(requireOpenable(setWith(Split::Test), "/nowhere/at/all"), InputError);
  EXPECT_THROW(openTestRuns(setWith(Split::Test), "/nowhere/at/all", "first"), InputError);
}

}  // namespace
}  // namespace nao::validation
