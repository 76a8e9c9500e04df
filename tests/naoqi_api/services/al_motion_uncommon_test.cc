// Methods of ALMotion that hardly anybody calls: torques, contacts, history, solids.

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;

class AlMotionUncommon : public ServicesBench {
 protected:
  std::vector<float> floats(const std::string& method, const std::vector<Value>& arguments = {}) {
    return call("ALMotion", method, arguments).to<std::vector<float>>();
  }
  std::string refusal(const std::string& method, const std::vector<Value>& arguments) {
    return call("ALMotion", method, arguments).print();
  }
  Joint joint(const char* name) const { return *bench_.model->findJoint(name); }
  const Actuator& motor(const char* name) const {
    return bench_.model->actuators[index(joint(name))];
  }
  // [s, us] as an image's stamp; the clock of this robot starts at 0.
  static Value stamp(double seconds) {
    const auto whole = static_cast<int>(seconds);
    return Value::list({whole, static_cast<int>((seconds - whole) * 1e6 + 0.5)});
  }
  // One that has solids.
  Value link() { return call("ALMotion", "_getCollisionNames").findItems()->front(); }
  // Names of links in [[link, ...], ...].
  static std::vector<std::string> namesIn(const Value& list) {
    std::vector<std::string> names;
    for (const Value& item : *list.findItems())
      names.push_back(*item.findItems()->at(0).findText());
    return names;
  }
};

TEST_F(AlMotionUncommon, ACurrentMakesATorqueTowardsTheCommand) {
  call("ALMotion", "wakeUp");
  const Actuator& knee = motor("LKneePitch");
  bench_.frame.current = JointArray<double>(bench_.model->jointCount());
  bench_.frame.current[joint("LKneePitch")] = 1;
  bench_.frame.angle[joint("LKneePitch")] += 0.02;  // below its command
  bench_.ports->publish(std::make_shared<const SensorFrame>(bench_.frame));
  const double constant = knee.efficiency * 21.6 / knee.no_load_speed;
  EXPECT_NEAR(floats("_getTorque", {"LKneePitch", true})[0], -constant, 1e-4);
  EXPECT_NEAR(floats("_getTorque", {"LKneePitch", false})[0], -0.02 * knee.kp, 1e-3);
}

TEST_F(AlMotionUncommon, ALimpJointIsAskedForNoTorque) {
  bench_.frame.angle[joint("LKneePitch")] += 0.05;
  bench_.ports->publish(std::make_shared<const SensorFrame>(bench_.frame));
  EXPECT_EQ(floats("_getTorque", {"LKneePitch", false})[0], 0);
  EXPECT_EQ(floats("_getTorque", {"Body", false}).size(),
            call("ALMotion", "getBodyNames", {"Body"}).findItems()->size());
}

TEST_F(AlMotionUncommon, TheFeetOfAStandingRobotAreOnTheGroundAndNothingElseIs) {
  const auto touching = namesIn(call("ALMotion", "_getGroundCollision"));
  EXPECT_EQ(touching.size(), 2U);
  EXPECT_TRUE(call("ALMotion", "_getGroundCollisionForFallManager").findItems()->empty());
  bench_.frame.feet[0].total = 0;
  run(0.05);
  EXPECT_EQ(call("ALMotion", "_getGroundCollisionForForceContact").findItems()->size(), 1U);
}

TEST_F(AlMotionUncommon, ARobotOnItsBackTouchesTheGroundWithMoreThanItsFeet) {
  bench_.frame.angle_y = -1.57;
  run(0.05);
  EXPECT_FALSE(call("ALMotion", "_getGroundCollisionForFallManager").findItems()->empty());
}

TEST_F(AlMotionUncommon, TheDangerousRegionReachesAsFarAsTheSecurityDistance) {
  call("ALMotion", "setOrthogonalSecurityDistance", {0.55F});
  double farthest = 0;
  const Value corners = call("ALMotion", "_getDangerousRegion");
  for (const Value& corner : *corners.findItems()) {
    farthest = std::max(farthest, number(corner.findItems()->at(0)));
  }
  EXPECT_NEAR(farthest, 0.55, 1e-6);
}

TEST_F(AlMotionUncommon, KnowsWhereTheCameraWasWhenAnImageWasTaken) {
  call("ALMotion", "wakeUp");
  const double before = now();
  const auto then = floats("getTransform", {"CameraTop", 0, true});
  call("ALMotion", "angleInterpolation", {"HeadYaw", 0.8F, 1.0F, true});
  run(0.1);
  const auto later = floats("getTransform", {"CameraTop", 0, true});
  const auto told = floats("_getSensorTransformAtTime", {"CameraTop", stamp(before)});
  ASSERT_EQ(told.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(told[i], then[i], 1e-4) << i;
  EXPECT_GT(std::abs(later[0] - told[0]), 0.1);
}

TEST_F(AlMotionUncommon, OfATimeThatIsNotKeptNothingIsTold) {
  EXPECT_NE(refusal("_getSensorTransformAtTime", {"CameraTop", stamp(now() + 1)}).find("are kept"),
            std::string::npos);
  run(3);
  EXPECT_NE(refusal("_getSensorTransformAtTime", {"CameraTop", stamp(0.02)}).find("are kept"),
            std::string::npos);
  EXPECT_NE(refusal("_getSensorTransformAtTime", {"CameraTop", "now"}).find("! "),
            std::string::npos);
  EXPECT_NE(refusal("_getSensorTransformAtTime", {"Nose", stamp(now())}).find("unknown"),
            std::string::npos);
}

TEST_F(AlMotionUncommon, TheWayThereAndBackAddsUp) {
  bench_.gait->legs = 0;  // upright
  call("ALMotion", "wakeUp");
  const auto begin = floats("_getCumulatedDisplacement");
  const float start = floats("getRobotPosition", {false})[0];
  call("ALMotion", "moveTo", {0.1F, 0.0F, 0.0F});
  const float there = floats("getRobotPosition", {false})[0];
  call("ALMotion", "moveTo", {-0.1F, 0.0F, 0.0F});
  const float back = floats("getRobotPosition", {false})[0];
  ASSERT_NE(there, start);
  const auto end = floats("_getCumulatedDisplacement");
  EXPECT_NEAR(end[0] - begin[0], std::abs(there - start) + std::abs(back - there), 1e-4);
}

TEST_F(AlMotionUncommon, CommandsThatNoJointCanFollowAreCounted) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "_resetNumJointCommandDiscontinuities");
  call("ALMotion", "setAngles", {"HeadYaw", 1.0F, 0.5F});
  run(1);
  EXPECT_EQ(call("ALMotion", "_getNumJointCommandDiscontinuities"), Value(0U));
  const auto time = static_cast<int>(now() * 1000) + 20;
  call("DCM", "set",
       {Value::list({"HeadYaw/Position/Actuator/Value", "Merge",
                     Value::list({Value::list({-1.0F, time})})})});
  run(0.5);
  EXPECT_GT(number(call("ALMotion", "_getNumJointCommandDiscontinuities")), 0);
  call("ALMotion", "_resetNumJointCommandDiscontinuities");
  EXPECT_EQ(call("ALMotion", "_getNumJointCommandDiscontinuities"), Value(0U));
}

TEST_F(AlMotionUncommon, APostureIsKeptBesideTheRobotsOwn) {
  const auto zero = floats("_getMotionPosture", {"StandZero"});
  auto mine = zero;
  mine[0] = 0.3F;
  EXPECT_EQ(call("ALMotion", "_setMotionPosture", {"Mine", rpc::toValue(mine)}), Value(true));
  EXPECT_EQ(floats("_getMotionPosture", {"Mine"}), mine);
  EXPECT_EQ(call("ALMotion", "_setMotionPosture", {"StandZero", rpc::toValue(mine)}), Value(false));
  EXPECT_EQ(floats("_getMotionPosture", {"StandZero"}), zero);
  EXPECT_NE(refusal("_setMotionPosture", {"Short", Value::list({1.0F})}).find("expected"),
            std::string::npos);
}

TEST_F(AlMotionUncommon, ToldSolidsAreLookedAtInPlaceOfTheRobotsOwn) {
  const Value before = call("ALMotion", "_getDetectedCollisions", {0.001F});
  const Value head = Value::list({link()});
  const Value none = Value::list({});
  const Value places = Value::list({Value::list({0.0F, 0.0F, 0.0F})});
  const Value big = Value::list({Value::list({"Sphere", Value::list({0.5F})})});
  EXPECT_EQ(call("ALMotion", "_setCollisionShapes", {head, none, big, places}), Value());
  EXPECT_GT(call("ALMotion", "_getDetectedCollisions", {0.001F}).findItems()->size(),
            before.findItems()->size());
  const Value sizes = Value::list({Value::list({0.04F, 0.02F})});
  EXPECT_EQ(call("ALMotion", "_setCollisionShapes",
                 {Value::list({"one"}), none, head, Value::list({"Pill"}), sizes, places}),
            Value());
  EXPECT_EQ(namesIn(call("ALMotion", "_getCollisionShapes", {link()})),
            std::vector<std::string>{"Pill"});
}

TEST_F(AlMotionUncommon, SolidsThatAreNoneAreRefusedAndChangeNothing) {
  const Value before = call("ALMotion", "_getCollisionShapes", {link()});
  const Value place = Value::list({0.0F, 0.0F, 0.0F});
  for (const Value& solid : {Value::list({"Cone", Value::list({0.5F})}),
                             Value::list({"Sphere", Value::list({-1.0F})}), Value("Sphere")}) {
    EXPECT_NE(refusal("_setCollisionShapes", {Value::list({link()}), Value::list({}),
                                              Value::list({solid}), Value::list({place})})
                  .find("! "),
              std::string::npos);
  }
  EXPECT_EQ(call("ALMotion", "_getCollisionShapes", {link()}), before);
}

TEST_F(AlMotionUncommon, FallingLetsGoOfAllJoints) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "_fall", {0.3F});
  for (const float stiffness : floats("getStiffnesses", {"Body"})) EXPECT_EQ(stiffness, 0);
}

TEST_F(AlMotionUncommon, ShutdownIsRestAndTheHostGoesOn) {
  call("ALMotion", "wakeUp");
  call("ALMotion", "_shutdown");
  EXPECT_EQ(call("ALMotion", "robotIsWakeUp"), Value(false));
  EXPECT_EQ(call("ALMotion", "ping"), Value(true));
}

TEST_F(AlMotionUncommon, BalanceRecoveryEndsAWalkOverTheFeet) {
  bench_.gait->legs = 0;  // upright
  call("ALMotion", "wakeUp");
  call("ALMotion", "move", {0.05F, 0.0F, 0.0F});
  run(1);
  call("ALMotion", "_balanceRecovery");
  EXPECT_EQ(call("ALMotion", "moveIsActive"), Value(false));
  const auto com = floats("_getComWorld");
  const auto centre = floats("_getSupportPolygonCenter");
  EXPECT_NEAR(com[1], centre[1], 0.01);
}

TEST_F(AlMotionUncommon, ToThePodIsAWalk) {
  bench_.gait->legs = 0;  // upright
  call("ALMotion", "wakeUp");
  const auto before = floats("getRobotPosition", {false});
  call("ALMotion", "_moveToPod", {0.1F, 0.0F, 0.0F});
  EXPECT_GT(floats("getRobotPosition", {false})[0] - before[0], 0);
}

}  // namespace
}  // namespace nao::services
