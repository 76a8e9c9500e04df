#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class AlMotionInner : public ServicesBench {
 protected:
  std::vector<float> floats(const std::string& method, const std::vector<Value>& arguments = {}) {
    return call("ALMotion", method, arguments).to<std::vector<float>>();
  }
};

TEST_F(AlMotionInner, TellsAPostureInTheOrderOfBody) {
  const auto names = call("ALMotion", "getBodyNames", {"Body"}).to<std::vector<std::string>>();
  const auto angles = floats("_getMotionPosture", {"StandZero"});
  ASSERT_EQ(angles.size(), names.size());
  EXPECT_NE(floats("_getMotionPosture", {"Crouch"}), angles);
  EXPECT_TRUE(call("ALMotion", "_getMotionPosture", {"Nowhere"}).findText());
}

TEST_F(AlMotionInner, HasTheIdsOfAV5) {
  const auto service = hub_.findService("ALMotion");
  EXPECT_EQ(service->findMethod(116)->name, "_rest");
  EXPECT_EQ(service->findMethod(213)->name, "_wbDefaultConfiguration");
  EXPECT_EQ(service->findMethod(307)->name, "_getComWorld");
}

TEST_F(AlMotionInner, FullLimitsAreNotNarrowerThanThoseOfCommands) {
  const auto full = call("ALMotion", "_getFullLimits", {"LKneePitch"}).findItems()->at(0);
  const auto limits = call("ALMotion", "getLimits", {"LKneePitch"}).findItems()->at(0);
  EXPECT_LE(number(full.findItems()->at(0)), number(limits.findItems()->at(0)));
  EXPECT_GE(number(full.findItems()->at(1)), number(limits.findItems()->at(1)));
}

TEST_F(AlMotionInner, InertiaIsSymmetricAndPositive) {
  const auto inertia = floats("_getInertia", {"LShoulderPitch"});
  ASSERT_EQ(inertia.size(), 9U);
  EXPECT_FLOAT_EQ(inertia[1], inertia[3]);
  EXPECT_GT(inertia[0], 0);
}

TEST_F(AlMotionInner, TheCentreOfMassIsOverTheSupportPolygon) {
  const auto com = floats("_getComWorld");
  const auto centre = floats("_getSupportPolygonCenter");
  ASSERT_EQ(centre.size(), 2U);
  EXPECT_NEAR(com[0], centre[0], 0.05);
  EXPECT_NEAR(com[1], centre[1], 0.02);
  EXPECT_GE(floats("_getSupportPolygon").size(), 6U);
}

TEST_F(AlMotionInner, TheGroundHullHoldsTheSoles) {
  const auto hull = call("ALMotion", "_getRobotGroundConvexHull");
  EXPECT_GE(hull.findItems()->size(), 3U);
  const auto ground = floats("_getGroundPlaneTf");
  ASSERT_EQ(ground.size(), 16U);
  EXPECT_NEAR(ground[11], 0, 1e-6);  // the floor
}

TEST_F(AlMotionInner, KnowsWhichJointsMove) {
  call("ALMotion", "wakeUp");
  const auto still = call("ALMotion", "_getJointIsMoving", {true}).to<std::vector<int>>();
  EXPECT_EQ(std::count(still.begin(), still.end(), 1), 0);
  call("ALMotion", "setAngles", {"HeadYaw", 0.8F, 0.2F});
  run(0.1);
  const auto moving = call("ALMotion", "_getJointIsMoving", {true}).to<std::vector<int>>();
  EXPECT_EQ(moving[0], 1);
  EXPECT_EQ(std::count(moving.begin(), moving.end(), 1), 1);
  const auto chains = call("ALMotion", "_getChainIsMoving", {true}).to<std::vector<int>>();
  EXPECT_EQ(std::count(chains.begin(), chains.end(), 1), 1);
}

TEST_F(AlMotionInner, LooksAtAPlace) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "_lookAt", {Value::list({1.0F, 1.0F, 0.0F}), 2, 0.5F});
  run(3);
  const auto yaw = floats("getAngles", {"HeadYaw", true});
  EXPECT_NEAR(yaw[0], 0.79, 0.05);
  EXPECT_GT(floats("getAngles", {"HeadPitch", true})[0], 0.1);  // the floor is below the head
}

TEST_F(AlMotionInner, ListsSolidsThatAreNear) {
  EXPECT_FALSE(call("ALMotion", "_getCollisionNames").findItems()->empty());
  EXPECT_GT(call("ALMotion", "_getDetectedCollisions", {0.2F}).findItems()->size(),
            call("ALMotion", "_getDetectedCollisions", {0.01F}).findItems()->size());
}

TEST_F(AlMotionInner, TellsWhatTheWholeBodyWasAskedFor) {
  EXPECT_EQ(call("ALMotion", "_wbIsActive"), Value(false));
  call("ALMotion", "wbEnable", {true});
  call("ALMotion", "wbFootState", {"Fixed", "LLeg"});
  call("ALMotion", "wbEnableBalanceConstraint", {true, "Legs"});
  EXPECT_EQ(call("ALMotion", "_wbIsActive"), Value(true));
  EXPECT_EQ(call("ALMotion", "_wbGetFootState", {"LLeg"}), Value("Fixed"));
  EXPECT_EQ(call("ALMotion", "_wbGetFootState", {"RLeg"}), Value("Free"));
  EXPECT_EQ(call("ALMotion", "_wbGetBalanceState"), Value("Legs"));
  call("ALMotion", "wbEnable", {false});
  EXPECT_EQ(call("ALMotion", "_wbGetBalanceState"), Value(""));
}

TEST_F(AlMotionInner, RelaxesAChain) {
  call("ALMotion", "wakeUp");
  EXPECT_EQ(call("ALMotion", "_isChainGoToOrInRest", {"LArm"}), Value(false));
  call("ALMotion", "_relax", {"LArm"});
  EXPECT_EQ(call("ALMotion", "_isChainGoToOrInRest", {"LArm"}), Value(true));
}

}  // namespace
}  // namespace nao::services
