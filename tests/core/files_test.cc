#include "core/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/check.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/unprivileged.h"

namespace nao {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

template <class Action>
std::string complaintOf(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Files, AreWrittenWhole) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.txt", "much longer than what comes");
  writeFile("--report", file, "short\n");
  EXPECT_EQ(contentOf(file), "short\n");
  appendToFile("", file, "more\n");
  EXPECT_EQ(contentOf(file), "short\nmore\n");
}

// A disk that is full takes a short text into its buffer without a word.
TEST(Files, AFullDiskIsToldWithTheOption) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  EXPECT_EQ(complaintOf([] { writeFile("--report", "/dev/full", "a"); }),
            "--report /dev/full: the file can not be written");
  EXPECT_EQ(complaintOf([] { appendToFile("", "/dev/full", "a"); }),
            "/dev/full: the file can not be written");
}

TEST(Files, FoldersAreListedByName) {
  const TemporaryFolder folder;
  const std::string b = folder.write("b.txt", ""), a = folder.write("a/deep/x.txt", "");
  EXPECT_EQ(listFolder(folder.path()), (std::vector<fs::path>{folder.path() + "/a", b}));
  EXPECT_EQ(listFilesBelow(folder.path()), (std::vector<fs::path>{a, b}));
}

TEST(Files, AFolderThatCanNotBeReadIsTold) {
  const TemporaryFolder folder;
  const std::string open = folder.write("open/a.txt", "");
  folder.write("closed/a.txt", "");
  fs::permissions(folder.path(), fs::perms::all);
  fs::permissions(folder.path() + "/closed", fs::perms::none);
  const Unprivileged nobody;
  EXPECT_EQ(complaintOf([&] { listFilesBelow(folder.path()); }),
            folder.path() + ": expected a folder that can be read");
  EXPECT_EQ(complaintOf([&] { listFolder(folder.path() + "/closed"); }),
            folder.path() + "/closed: expected a folder that can be read");
  EXPECT_EQ(listReadableBelow(folder.path()), std::vector<fs::path>{open});
  EXPECT_TRUE(listReadable(folder.path() + "/closed").empty());
}

}  // namespace
}  // namespace nao
