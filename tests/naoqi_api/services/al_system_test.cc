#include "naoqi_api/services/al_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace nao::services {
namespace {

using rpc::Value;
using ::testing::ElementsAre;

class AlSystemTest : public ::testing::Test {
 protected:
  // The value of a call, or "! " and its error.
  Value call(const std::string& method, const std::vector<Value>& arguments = {}) {
    const auto result = service_.call(method, arguments);
    if (!result.isDone()) return "! still running";
    const auto& outcome = *result.outcome();
    return outcome.error ? Value("! " + *outcome.error) : *outcome.value;
  }

  memory::MemoryStore memory_{[] { return Duration(); }};
  AlSystem system_{memory_, "nao"};
  rpc::Service service_ = system_.describe();
};

TEST_F(AlSystemTest, TellsNameAndVersion) {
  EXPECT_EQ(call("robotName"), Value("nao"));
  EXPECT_EQ(call("systemVersion"), Value("2.1.4.13"));
  EXPECT_EQ(call("systemVersion"), call("version"));
  EXPECT_EQ(call("previousSystemVersion"), Value(""));
}

TEST_F(AlSystemTest, RenamingRaisesItsEvent) {
  std::vector<std::string> heard;
  const auto token = memory_.listen(
      "ALSystem/RobotNameChanged",
      [&](const std::string&, const Value& value) { heard.push_back(value.print()); });
  EXPECT_EQ(call("setRobotName", {"nelson"}), Value(true));
  EXPECT_EQ(call("setRobotName", {""}), Value(false));
  EXPECT_EQ(call("setRobotName", {std::string(65, 'x')}), Value(false));
  EXPECT_EQ(call("robotName"), Value("nelson"));
  EXPECT_THAT(heard, ElementsAre("\"nelson\""));
}

TEST_F(AlSystemTest, KeepsATimezoneThatLooksLikeOne) {
  EXPECT_EQ(call("timezone"), Value("UTC"));
  EXPECT_EQ(call("setTimezone", {"Europe/Amsterdam"}), Value(true));
  EXPECT_EQ(call("setTimezone", {"../../etc/passwd"}), Value(false));
  EXPECT_EQ(call("setTimezone", {""}), Value(false));
  EXPECT_EQ(call("timezone"), Value("Europe/Amsterdam"));
}

TEST_F(AlSystemTest, MemoryAndDiskAreThoseOfAComputer) {
  const int total = call("totalMemory").to<int>();
  const int available = call("freeMemory").to<int>();
  constexpr int kMegabyte = 1024;  // [kB]
  EXPECT_GT(total, 64 * kMegabyte);
  EXPECT_GT(available, 0);
  EXPECT_LE(available, total);
  const Value disks = call("diskFree", {false});
  ASSERT_NE(disks.findItems(), nullptr);
  ASSERT_EQ(disks.findItems()->size(), 1U);
  const auto& partition = *disks.findItems()->front().findItems();
  EXPECT_EQ(partition[1], Value("/"));
  EXPECT_LE(partition[3].findNumber(), partition[2].findNumber());
  EXPECT_GT(partition[2].findNumber(), 0.0);
}

}  // namespace
}  // namespace nao::services
