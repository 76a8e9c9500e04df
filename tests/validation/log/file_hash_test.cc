#include "validation/log/file_hash.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/core/temporary_folder.h"

namespace nao::validation {
namespace {

TEST(FileHash, IsOfNamesAndContents) {
  const TemporaryFolder folder;
  folder.write("a", "abc");
  // printf '1:a3:abc' | sha256sum
  EXPECT_EQ(sha256OfFolder(folder.path()),
            "872b00a5f28c9d346f8f4116f2a9147928b1be8b645ffcdadd9a8323a7b930bc");
  folder.write("b/c", "");
  // printf '1:a3:abc3:b/c0:' | sha256sum
  EXPECT_EQ(sha256OfFolder(folder.path()),
            "fb9609dc35771e4803a27900c2785618cc934df9438f5ef047f507966e5acda7");
}

TEST(FileHash, LeavesOutWhatItIsToldTo) {
  const TemporaryFolder folder;
  folder.write("a", "abc");
  const std::string alone = sha256OfFolder(folder.path());
  folder.write("out/report.json", "{}");
  folder.write("looks.txt", "one");
  EXPECT_NE(sha256OfFolder(folder.path()), alone);
  const std::string place = folder.path();
  EXPECT_EQ(sha256OfFolder(place, {"", place + "/out", place + "/looks.txt"}), alone);
}

TEST(FileHash, SaysWhichFolderIsMissing) {
  const TemporaryFolder folder;
  EXPECT_THROW(sha256OfFolder(folder.path() + "/none"), InputError);
}

}  // namespace
}  // namespace nao::validation
