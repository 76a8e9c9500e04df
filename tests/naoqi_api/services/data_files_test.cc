#include "naoqi_api/services/data_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

namespace fs = std::filesystem;
using rpc::CallError;

class DataFiles : public testing::Test {
 protected:
  DataFiles() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "inside");
    std::ofstream(folder_.parent_path() / "outside.wav") << "x";
  }
  ~DataFiles() override { fs::remove_all(folder_.parent_path()); }

  fs::path folder_ = fs::path(testing::TempDir()) / "nao_data_files_test" / "data";
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

}  // namespace
}  // namespace nao::services
