#include "validation/diagnosis/jobs/kept_work.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;

class KeptWorkTest : public testing::Test {
 protected:
  KeptWork open(const std::string& key) const { return {folder_.path() + "/kept", key}; }
  TemporaryFolder folder_;
};

TEST_F(KeptWorkTest, FindsWhatWasKeptUnderTheSameKey) {
  const std::string content("a\0b\n", 4);
  open("one").keep("a joint/unit", content);
  const KeptWork again = open("one");
  EXPECT_EQ(again.found(), KeptWork::Found::Same);
  EXPECT_EQ(again.find("a joint/unit"), content);
  EXPECT_EQ(again.find("another"), std::nullopt);
}

TEST_F(KeptWorkTest, StartsAnewUnderAnotherKey) {
  EXPECT_EQ(open("one").found(), KeptWork::Found::Nothing);
  open("one").keep("unit", "content");
  const KeptWork other = open("two");
  EXPECT_EQ(other.found(), KeptWork::Found::Other);
  EXPECT_EQ(other.find("unit"), std::nullopt);
  EXPECT_EQ(open("two").found(), KeptWork::Found::Same);
}

TEST_F(KeptWorkTest, AFileThatWasCutOffIsNotThere) {
  open("one").keep("unit", "a long content");
  int cut = 0;
  for (const auto& entry : fs::directory_iterator(folder_.path() + "/kept")) {
    if (entry.path().filename().string().rfind("unit", 0) != 0) continue;
    fs::resize_file(entry.path(), fs::file_size(entry.path()) - 1);
    ++cut;
  }
  ASSERT_EQ(cut, 1);
  EXPECT_EQ(open("one").find("unit"), std::nullopt);
}

TEST_F(KeptWorkTest, RemembersWithoutWorkingTwice) {
  int worked = 0;
  const auto work = [&] { return std::to_string(++worked); };
  EXPECT_EQ(open("one").remember("unit", work), "1");
  EXPECT_EQ(open("one").remember("unit", work), "1");
  EXPECT_EQ(worked, 1);
  open("one").discard();
  EXPECT_FALSE(fs::exists(folder_.path() + "/kept"));
}

TEST_F(KeptWorkTest, SaysWhereItCanNotWrite) {
  const std::string file = folder_.write("file", "");
  EXPECT_THROW(KeptWork(file + "/kept", "one"), InputError);
}

TEST_F(KeptWorkTest, WithoutAFolderKeepsNothing) {
  const KeptWork none;
  none.keep("unit", "content");
  EXPECT_EQ(none.find("unit"), std::nullopt);
}

TEST_F(KeptWorkTest, TwoThreadsMayKeepTheSame) {
  const KeptWork kept = open("one");
  const std::string content(10000, 'x');
  const auto keep = [&] {
    for (int i = 0; i < 100; ++i) kept.keep("unit", content);
  };
  std::thread other(keep);
  EXPECT_NO_THROW(keep());
  other.join();
  EXPECT_EQ(kept.find("unit"), content);
}

}  // namespace
}  // namespace nao::validation
