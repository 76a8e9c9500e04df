#include <gtest/gtest.h>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

// A Nao with its collision solids.
class AlMotionProtectionTest : public testing::Test {
 protected:
  AlMotionProtectionTest() {
    bench.cycle();
    call("wakeUp");
  }
  Value call(const std::string& name, const std::vector<Value>& arguments = {}) {
    return bench.call(*motion, name, arguments);
  }
  std::string nearness(const char* chain) { return *call("isCollision", {chain}).findText(); }
  double angle(const char* joint) {
    return call("getAngles", {joint, false}).to<std::vector<float>>()[0];
  }
  void foldLeftArm() {
    const Value names = Value::list({"LShoulderPitch", "LShoulderRoll", "LElbowYaw", "LElbowRoll"});
    call("angleInterpolationWithSpeed", {names, Value::list({1.5, -0.3, 0.0, -1.5}), 0.3});
  }

  RobotBench bench{loadRobotModel(std::string(NAO_SOURCE_DIR) + "/robots", "nao_h21_v33")};
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
};

TEST_F(AlMotionProtectionTest, AGuardedArmStopsAndSaysHowNearItIs) {
  EXPECT_EQ(nearness("Arms"), "none");
  foldLeftArm();
  EXPECT_EQ(nearness("LArm"), "collision");
  EXPECT_EQ(nearness("RArm"), "none");
  EXPECT_EQ(nearness("Body"), "collision");
  EXPECT_GT(angle("LShoulderRoll"), -0.28);
}

TEST_F(AlMotionProtectionTest, ProtectionCanBeSwitchedOffForOneArm) {
  EXPECT_TRUE(call("setCollisionProtectionEnabled", {"LArm", false}).to<bool>());
  foldLeftArm();
  EXPECT_NEAR(angle("LShoulderRoll"), -0.3, 1e-6);
  EXPECT_NEAR(angle("LElbowRoll"), -1.5, 1e-6);
  EXPECT_TRUE(call("getCollisionProtectionEnabled", {"RArm"}).to<bool>());
  EXPECT_FALSE(call("getCollisionProtectionEnabled", {"Arms"}).to<bool>());
}

TEST_F(AlMotionProtectionTest, OnlyArmsAreGuarded) {
  EXPECT_EQ(bench.errorOf(*motion, "setCollisionProtectionEnabled", {"LLeg", true}),
            "\tALMotion::setCollisionProtectionEnabled\n\texpected LArm, RArm or Arms, got LLeg");
  EXPECT_EQ(bench.errorOf(*motion, "isCollision", {"Head"}),
            "\tALMotion::isCollision\n\texpected LArm, RArm or Arms, got Head");
}

TEST_F(AlMotionProtectionTest, WalkProtectionsAreMotionConfig) {
  call("setMotionConfig", {Value::list({Value::list({"ENABLE_STIFFNESS_PROTECTION", false}),
                                        Value::list({"ENABLE_SOMETHING_ELSE", 1})})});
  call("setStiffnesses", {"LKneePitch", 0.5});
  call("moveToward", {0.5, 0.0, 0.0});
  bench.run(3);
  EXPECT_TRUE(call("moveIsActive").to<bool>());
  call("setMotionConfig", {Value::list({"ENABLE_STIFFNESS_PROTECTION", true})});
  bench.run(0.1);
  EXPECT_FALSE(call("moveIsActive").to<bool>());
  EXPECT_EQ(bench.errorOf(*motion, "setMotionConfig", {5}),
            "\tALMotion::setMotionConfig\n\texpected [[name, value], ...]");
}

}  // namespace
}  // namespace nao::services
