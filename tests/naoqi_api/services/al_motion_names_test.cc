#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

namespace fs = std::filesystem;

// What the list of a robot's methods has and ours has not, and why.
const std::map<std::string, std::string> kMissing = {
    {"getPushRecoveryEnabled(v)", "a slip of the list: it is there without arguments"},
    {"pCall()", "a slip of the list: it takes one argument"},
    {"setTransforms(si[f]fi)", "setTransforms(mmmfm) takes such arguments"},
    {"wait(i)", "before 2.0; a V5 has wait(ii) alone"},
};

// A line of comma separated values; quotes protect commas.
std::vector<std::string> splitLine(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

struct Row {
  std::string name;
  std::string parameters;
  std::string uid;  // empty: a V5 does not list it
};

std::vector<Row> publicMethods(const fs::path& table) {
  std::ifstream file(table);
  std::vector<Row> rows;
  std::string line;
  std::getline(file, line);  // the head
  while (std::getline(file, line)) {
    const auto cells = splitLine(line);
    if (cells.size() > 11 && cells[0][0] != '_') rows.push_back({cells[0], cells[3], cells[11]});
  }
  return rows;
}

class AlMotionNamesTest : public testing::Test {
 protected:
  void SetUp() override {
    const fs::path table = fs::path(NAO_SOURCE_DIR) / ".." / "shared/data/api/ALMotion.csv";
    if (!fs::exists(table)) GTEST_SKIP() << "needs " << table;
    rows_ = publicMethods(table);
    ASSERT_GT(rows_.size(), 100U) << "of " << table;
  }
  bool has(const Row& row) const {
    for (const auto& [uid, method] : motion_->methods()) {
      if (method.name == row.name && method.parameters_signature == row.parameters) return true;
    }
    return false;
  }

  RobotBench bench_;
  std::shared_ptr<rpc::Service> motion_ = makeAlMotion(bench_.link);
  std::vector<Row> rows_;
};

TEST_F(AlMotionNamesTest, EveryPublicMethodIsThereButThoseOfWhichWeKnow) {
  for (const Row& row : rows_) {
    const bool is_missing = kMissing.count(row.name + row.parameters) == 1;
    EXPECT_NE(has(row), is_missing) << row.name << row.parameters;
  }
}

TEST_F(AlMotionNamesTest, MethodsHaveTheNumbersOfARealRobot) {
  for (const Row& row : rows_) {
    if (row.uid.empty() || !has(row)) continue;
    const rpc::Method* ours = motion_->findMethod(static_cast<std::uint32_t>(std::stoul(row.uid)));
    ASSERT_NE(ours, nullptr) << row.uid << " " << row.name;
    EXPECT_EQ(ours->name + ours->parameters_signature, row.name + row.parameters) << row.uid;
  }
}

}  // namespace
}  // namespace nao::services
