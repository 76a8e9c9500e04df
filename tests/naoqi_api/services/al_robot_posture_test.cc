#include "naoqi_api/services/al_robot_posture.h"

#include <gtest/gtest.h>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Names = std::vector<std::string>;

class AlRobotPostureTest : public testing::Test {
 protected:
  AlRobotPostureTest() {
    bench.cycle();
    bench.call(*motion, "wakeUp", {});
  }
  Value call(const std::string& name, const std::vector<Value>& arguments = {}) {
    return bench.call(*posture, name, arguments);
  }

  RobotBench bench;
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
  std::shared_ptr<rpc::Service> posture = makeAlRobotPosture(bench.link);
};

TEST_F(AlRobotPostureTest, GoesToPosturesAndKnowsThem) {
  EXPECT_TRUE(call("goToPosture", {"Stand", 0.8F}).to<bool>());
  EXPECT_EQ(*call("getPosture").findText(), "Stand");
  EXPECT_EQ(*call("getPostureFamily").findText(), "Standing");
  EXPECT_TRUE(call("goToPosture", {"Crouch", 1}).to<bool>());  // an int for a speed
  EXPECT_EQ(*call("getPostureFamily").findText(), "Crouching");
  EXPECT_TRUE(call("applyPosture", {"StandInit", 0.8F}).to<bool>());
  EXPECT_EQ(*call("getPosture").findText(), "StandInit");
}

TEST_F(AlRobotPostureTest, ListsWhatThereIs) {
  EXPECT_EQ(call("getPostureList").to<Names>(), (Names{"Crouch", "StandInit", "Stand"}));
  EXPECT_EQ(call("getPostureFamilyList").to<Names>(), (Names{"Crouching", "Standing"}));
}

TEST_F(AlRobotPostureTest, SaysFalseWhenStoppedAndStaysWhereItIs) {
  const auto going = posture->call("goToPosture", {"Crouch", 0.5F});
  bench.run(1.0);
  call("stopMove");
  bench.run(0.05);
  ASSERT_TRUE(going.isDone());
  EXPECT_FALSE(going.outcome()->value->to<bool>());
  EXPECT_EQ(*call("getPosture").findText(), "Unknown");
}

TEST_F(AlRobotPostureTest, SaysFalseAfterAsManyTriesAsAllowed) {
  bench.call(*motion, "setStiffnesses", {"Body", 0.0F});
  bench.cycle();
  call("setMaxTryNumber", {1});
  EXPECT_FALSE(call("goToPosture", {"Crouch", 1.0F}).to<bool>());
  const double once = toSeconds(bench.link.now());
  call("setMaxTryNumber", {2});
  EXPECT_FALSE(call("goToPosture", {"Crouch", 1.0F}).to<bool>());
  EXPECT_GT(toSeconds(bench.link.now()) - once, 2.0);  // a second to arrive, twice
}

TEST_F(AlRobotPostureTest, UnknownNamesAreErrors) {
  EXPECT_EQ(bench.errorOf(*posture, "goToPosture", {"Handstand", 0.5F}),
            "\tALRobotPosture::goToPosture\n\tunknown posture name: Handstand");
  EXPECT_EQ(bench.errorOf(*posture, "setMaxTryNumber", {0}),
            "\tALRobotPosture::setMaxTryNumber\n\tthe number of tries must be at least 1");
}

}  // namespace
}  // namespace nao::services
