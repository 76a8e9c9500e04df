#include "naoqi_api/services/al_motion.h"

#include <gtest/gtest.h>

#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Floats = std::vector<float>;
using Calls = std::vector<std::string>;

Value list(std::vector<Value> items) { return Value::list(std::move(items)); }

class AlMotionTest : public testing::Test {
 protected:
  AlMotionTest() { bench.cycle(); }
  Value call(const std::string& name, const std::vector<Value>& arguments = {}) {
    return bench.call(*motion, name, arguments);
  }
  std::string errorOf(const std::string& name, const std::vector<Value>& arguments) {
    return bench.errorOf(*motion, name, arguments);
  }

  RobotBench bench;
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
};

TEST_F(AlMotionTest, WakesUpAndRests) {
  EXPECT_FALSE(call("robotIsWakeUp").to<bool>());
  call("wakeUp");
  EXPECT_TRUE(call("robotIsWakeUp").to<bool>());
  EXPECT_EQ(call("getStiffnesses", {"Body"}).to<Floats>(), Floats(22, 1.0F));
  EXPECT_NEAR(call("getAngles", {"LKneePitch", false}).to<Floats>()[0], 0.7, 1e-6);
  call("rest");
  EXPECT_FALSE(call("robotIsWakeUp").to<bool>());
  EXPECT_EQ(call("getStiffnesses", {"Body"}).to<Floats>(), Floats(22, 0.0F));
  EXPECT_NEAR(call("getAngles", {"LKneePitch", false}).to<Floats>()[0], 2.11, 1e-6);
}

TEST_F(AlMotionTest, StiffnessTakesEveryShape) {
  call("setStiffnesses", {"Head", 1});
  EXPECT_EQ(call("getStiffnesses", {"Head"}).to<Floats>(), (Floats{1, 1}));
  call("setStiffnesses", {list({"HeadYaw", "HeadPitch"}), list({0.25F, 0.5F})});
  EXPECT_EQ(call("getStiffnesses", {list({"HeadYaw", "HeadPitch"})}).to<Floats>(),
            (Floats{0.25F, 0.5F}));
  call("stiffnessInterpolation", {"Body", 1.0F, 1.0F});
  EXPECT_EQ(call("getStiffnesses", {"LKneePitch"}).to<Floats>(), (Floats{1}));
  call("stiffnessInterpolation", {list({"HeadYaw", "HeadPitch"}), list({0, 0.5F}), list({1, 2})});
  EXPECT_EQ(call("getStiffnesses", {"Head"}).to<Floats>(), (Floats{0, 0.5F}));
  call("rest", {"LArm"});
  EXPECT_EQ(call("getStiffnesses", {"LArm"}).to<Floats>(), Floats(4, 0.0F));
}

TEST_F(AlMotionTest, MoveToTakesEveryShapeAndWaits) {
  call("wakeUp");
  call("moveTo", {0.3F, 0, 1});
  EXPECT_DOUBLE_EQ(bench.gait->target.theta, 1);
  call("moveTo", {0, 0, 1.57F, 5.0F});
  EXPECT_FLOAT_EQ(static_cast<float>(bench.gait->target.theta), 1.57F);
  const Value config =
      list({list({"MaxStepX", 0.06F}), list({"Frequency", 0.5F}), list({"LeftStepHeight", 1})});
  call("walkTo", {0.1F, 0.0F, 0.0F, config});
  EXPECT_NEAR(bench.gait->config.max_step_x, 0.06, 1e-6);
  EXPECT_DOUBLE_EQ(bench.gait->config.max_step_frequency, 0.5);
  EXPECT_DOUBLE_EQ(bench.gait->config.step_height, 0.04);  // brought into its range
  call("moveTo", {0.1F, 0.0F, 0.0F, 3.0F, config});
  call("moveTo", {list({0.2F, 0, 0})});
  EXPECT_NEAR(bench.gait->target.x, 0.2, 1e-6);
  EXPECT_EQ(bench.gait->calls, Calls(5, "walkTo"));
}

TEST_F(AlMotionTest, APathIsWalkedPointByPoint) {
  call("wakeUp");
  call("moveTo", {list({list({0.2F, 0, 1.5707964F}), list({0.3F, 0.0F, 0.0F})})});
  EXPECT_EQ(bench.gait->calls, Calls(2, "walkTo"));
  EXPECT_NEAR(bench.gait->target.x, 0.3, 1e-6);  // as seen from the first point
  EXPECT_NEAR(bench.gait->target.y, 0, 1e-6);
}

TEST_F(AlMotionTest, VelocitiesDoNotWait) {
  call("wakeUp");
  call("moveToward", {1.0F, 0, 0});
  call("moveToward", {0.5F, 0.0F, 0.2F, list({list({"Frequency", 1.0F})})});
  call("move", {0.05F, 0.0F, 0.0F});
  call("setWalkTargetVelocity", {0.8F, 0, 0, 0.5F});
  bench.run(0.1);
  EXPECT_DOUBLE_EQ(bench.gait->config.max_step_frequency, 0.5);
  const Value foot = list({list({"StepHeight", 0.03F})});
  call("setWalkTargetVelocity", {2, 0.0F, 0.0F, 1, foot, foot});
  bench.run(0.1);
  EXPECT_DOUBLE_EQ(bench.gait->velocity.x, 1);  // fractions end at 1
  EXPECT_NEAR(bench.gait->config.step_height, 0.03, 1e-6);
  EXPECT_TRUE(call("moveIsActive").to<bool>());
  EXPECT_TRUE(call("walkIsActive").to<bool>());
  call("stopMove");
  EXPECT_FALSE(call("moveIsActive").to<bool>());
}

TEST_F(AlMotionTest, WaitUntilMoveIsFinishedWaits) {
  call("wakeUp");
  motion->call("moveTo", {0.3F, 0.0F, 0.0F});
  const auto wait = motion->call("waitUntilMoveIsFinished", {});
  bench.run(0.1);
  EXPECT_FALSE(wait.isDone());
  bench.run(0.3);
  EXPECT_TRUE(wait.isDone());
  EXPECT_TRUE(motion->call("waitUntilMoveIsFinished", {}).isDone());  // nobody walks
}

TEST_F(AlMotionTest, SoftLegsAreToldToTheWalker) {
  EXPECT_EQ(errorOf("moveTo", {0.3F, 0.0F, 0.0F}),
            "\tALMotion::moveTo\n\tthe legs are too soft to walk: every stiffness must be above "
            "0.6");
}

TEST_F(AlMotionTest, TellsWhereTheRobotWalked) {
  call("wakeUp");
  call("moveTo", {0.3F, 0.0F, 0.0F});
  const auto position = call("getRobotPosition", {true}).to<Floats>();
  ASSERT_EQ(position.size(), 3u);
  EXPECT_GT(position[0], 0.01F);
  EXPECT_EQ(call("getNextRobotPosition").to<Floats>().size(), 3u);
  EXPECT_EQ(call("getRobotVelocity").to<Floats>(), (Floats{0, 0, 0}));
}

TEST_F(AlMotionTest, MoveConfigurationIsListed) {
  const Value defaults = call("getMoveConfig", {"Default"});
  EXPECT_EQ((*defaults.findItems())[0].print(), list({"MaxStepX", 0.04F}).print());
  EXPECT_EQ(call("getFootGaitConfig", {"Max"}).findItems()->size(), 8u);
  EXPECT_EQ(errorOf("moveTo", {0.1F, 0.0F, 0.0F, list({list({"Speed", 1})})}),
            "\tALMotion::moveTo\n\tunknown name in the move configuration: Speed");
  // Text is never a number, as with ALValue, though a sample of ALNavigation's that went round in
  // public programs writes it so.
  EXPECT_EQ(errorOf("moveTo", {0.1F, 0.0F, 0.0F, list({list({"MaxStepX", "0.06"})})}),
            "\tALMotion::moveTo\n\texpected [name, value], got [\"MaxStepX\", \"0.06\"]");
}

TEST_F(AlMotionTest, TasksAreListedBookedAndKilled) {
  call("wakeUp");
  const auto pending = motion->call("angleInterpolation", {"HeadYaw", 1.0F, 5.0F, true});
  bench.run(0.1);
  const Value tasks = call("getTaskList");
  ASSERT_EQ(tasks.findItems()->size(), 1u);
  const auto& task = *(*tasks.findItems())[0].findItems();
  EXPECT_EQ(*task[0].findText(), "angleInterpolation");
  EXPECT_FALSE(call("areResourcesAvailable", {list({"Head"})}).to<bool>());
  EXPECT_TRUE(call("areResourcesAvailable", {list({"LArm"})}).to<bool>());
  EXPECT_FALSE(call("killTask", {987654}).to<bool>());
  EXPECT_TRUE(call("killTask", {task[1]}).to<bool>());
  bench.run(0.05);
  EXPECT_TRUE(pending.isDone());
  EXPECT_TRUE(call("getTaskList").findItems()->empty());

  motion->call("angleInterpolation", {"HeadYaw", 1.0F, 5.0F, true});
  bench.run(0.1);
  call("killTasksUsingResources", {list({"HeadYaw"})});
  bench.run(0.05);
  EXPECT_TRUE(call("areResourcesAvailable", {list({"Head"})}).to<bool>());
}

TEST_F(AlMotionTest, KnowsNamesAndLimits) {
  EXPECT_EQ(call("getBodyNames", {"Chains"}).to<Calls>(),
            (Calls{"Head", "LArm", "LLeg", "RLeg", "RArm"}));
  EXPECT_EQ(call("getJointNames", {"HeadYaw"}).to<Calls>(), (Calls{"HeadYaw"}));
  const Value limits = call("getLimits", {"Head"});
  ASSERT_EQ(limits.findItems()->size(), 2u);
  const auto yaw = (*limits.findItems())[0].to<Floats>();
  EXPECT_EQ(yaw, (Floats{-2.0857F, 2.0857F, 8.268F, 1.5F}));
  EXPECT_EQ(call("getLimits", {"Body"}).findItems()->size(), 22u);
  EXPECT_EQ(errorOf("getBodyNames", {"Tail"}),
            "\tALMotion::getBodyNames\n\tunknown joint or chain name: Tail");
}

TEST_F(AlMotionTest, DescribesTheRobot) {
  const Value config = call("getRobotConfig");
  ASSERT_EQ(config.findItems()->size(), 2u);
  const auto& names = *(*config.findItems())[0].findItems();
  const auto& values = *(*config.findItems())[1].findItems();
  ASSERT_EQ(names.size(), values.size());
  EXPECT_EQ(*values[0].findText(), "naoH21");
  EXPECT_EQ(*values[1].findText(), "VERSION_33");
  ASSERT_GT(names.size(), 7u);  // programs read number 7 without a look at its name
  EXPECT_EQ(*names[7].findText(), "Hands");
  EXPECT_FALSE(values[7].to<bool>());
  const std::string summary = *call("getSummary").findText();
  EXPECT_NE(summary.find("RHipYawPitch"), std::string::npos);
}

TEST_F(AlMotionTest, SwitchesAreRemembered) {
  EXPECT_TRUE(call("getFallManagerEnabled").to<bool>());
  call("setFallManagerEnabled", {false});
  EXPECT_FALSE(call("getFallManagerEnabled").to<bool>());
  EXPECT_TRUE(call("setCollisionProtectionEnabled", {"LArm", false}).to<bool>());
  EXPECT_FALSE(call("getCollisionProtectionEnabled", {"LArm"}).to<bool>());
  EXPECT_FALSE(call("getCollisionProtectionEnabled", {"Arms"}).to<bool>());
  EXPECT_TRUE(call("getCollisionProtectionEnabled", {"RArm"}).to<bool>());
  call("setExternalCollisionProtectionEnabled", {"All", false});
  EXPECT_FALSE(call("getExternalCollisionProtectionEnabled", {"Move"}).to<bool>());
  call("setBreathEnabled", {"Body", true});
  EXPECT_TRUE(call("getBreathEnabled", {"LArm"}).to<bool>());
  call("setMotionConfig", {list({list({"ENABLE_FOOT_CONTACT_PROTECTION", true})})});
  EXPECT_EQ(errorOf("setBreathEnabled", {"Tail", true}),
            "\tALMotion::setBreathEnabled\n\tunknown chain name: Tail");
}

TEST_F(AlMotionTest, ArmsOfTheWalkCanBeStilled) {
  call("wakeUp");
  call("setMoveArmsEnabled", {0, 1});  // ints for bools
  EXPECT_FALSE(call("getMoveArmsEnabled", {"LArm"}).to<bool>());
  EXPECT_EQ(call("getWalkArmsEnabled").to<std::vector<bool>>(), (std::vector<bool>{false, true}));
  call("setWalkArmsEnable", {true, false});  // as 1.12 called it
  EXPECT_EQ(call("getWalkArmsEnable").to<std::vector<bool>>(), (std::vector<bool>{true, false}));
  call("setWalkArmsEnabled", {false, true});
  call("moveToward", {1.0F, 0.0F, 0.0F});
  bench.run(1);
  EXPECT_NEAR(call("getAngles", {"LShoulderPitch", false}).to<Floats>()[0], 1.4, 1e-6);
  EXPECT_NEAR(call("getAngles", {"RShoulderPitch", false}).to<Floats>()[0], 1.2, 1e-6);
}

TEST_F(AlMotionTest, PushRecoveryIsASwitchOfTheWalk) {
  EXPECT_TRUE(call("getPushRecoveryEnabled").to<bool>());
  call("setPushRecoveryEnabled", {false});
  bench.run(1);
  EXPECT_FALSE(call("getPushRecoveryEnabled").to<bool>());
  EXPECT_FALSE(bench.gait->feedback.steps);
  EXPECT_TRUE(bench.gait->feedback.balance);
}

TEST_F(AlMotionTest, SpacesAreChecked) {
  EXPECT_EQ(errorOf("getPosition", {"Torso", 7, true}),
            "\tALMotion::getPosition\n\tunknown space 7: 0 is the torso's, 1 the world's, 2 the "
            "robot's");
}

}  // namespace
}  // namespace nao::services
