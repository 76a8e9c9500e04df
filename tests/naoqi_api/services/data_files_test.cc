#include "naoqi_api/services/data_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "naoqi_api/call_error.h"
#include "tests/core/temporary_folder.h"
#include "tests/core/unprivileged.h"

namespace nao::services {
namespace {

namespace fs = std::filesystem;
using rpc::CallError;

class DataFiles : public testing::Test {
 protected:
  DataFiles() {
    fs::create_directories(folder_ / "inside");
    place_.write("outside.wav", "x");
  }

  TemporaryFolder place_;
  fs::path folder_ = fs::path(place_.path()) / "data";
};

TEST_F(DataFiles, AbsoluteNamesLeadBelowTheFolderToo) {
  writeDataFile(folder_, "/home/nao/a.txt", "hello");
  EXPECT_TRUE(fs::is_regular_file(folder_ / "home/nao/a.txt"));
  EXPECT_TRUE(findDataFile(folder_, "home/nao/a.txt"));
  EXPECT_FALSE(findDataFile(folder_, "home/nao/b.txt"));
}

TEST_F(DataFiles, NothingLeadsOutOfTheFolder) {
  EXPECT_THROW(dataPath(folder_, "../outside.wav"), CallError);
  EXPECT_THROW(dataPath(folder_, "inside/../../outside.wav"), CallError);
  fs::create_symlink(folder_.parent_path(), folder_ / "link");
  EXPECT_THROW(dataPath(folder_, "link/outside.wav"), CallError);
  EXPECT_THROW(dataPath({}, "a.wav"), CallError);
}

TEST_F(DataFiles, TheQuotaHolds) {
  EXPECT_THROW(writeDataFile(folder_, "big", std::string(kDataQuota + 1, 'x')), CallError);
}

TEST_F(DataFiles, AFolderThatMayNotBeReadStopsNobody) {
  fs::create_directories(folder_ / "closed");
  fs::permissions(place_.path(), fs::perms::all);
  fs::permissions(folder_, fs::perms::all);
  fs::permissions(folder_ / "closed", fs::perms::none);
  const Unprivileged nobody;
  writeDataFile(folder_, "a.txt", "hello");
  EXPECT_TRUE(findDataFile(folder_, "a.txt"));
}

}  // namespace
}  // namespace nao::services
