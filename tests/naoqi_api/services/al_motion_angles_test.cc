#include <gtest/gtest.h>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Floats = std::vector<float>;
constexpr double kFloat = 1e-6;  // what a float of the wire keeps of an angle

Value list(std::vector<Value> items) { return Value::list(std::move(items)); }

class AlMotionAnglesTest : public testing::Test {
 protected:
  AlMotionAnglesTest() {
    bench.cycle();
    call("setStiffnesses", {"Body", 1.0F});
    bench.cycle();
  }
  Value call(const std::string& name, const std::vector<Value>& arguments) {
    return bench.call(*motion, name, arguments);
  }
  std::string errorOf(const std::string& name, const std::vector<Value>& arguments) {
    return bench.errorOf(*motion, name, arguments);
  }
  double angle(const char* joint) {
    return static_cast<double>(call("getAngles", {joint, false}).to<Floats>()[0]);
  }

  RobotBench bench;
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
};

TEST_F(AlMotionAnglesTest, HasTheIdsAndSignaturesOfTheRobot) {
  struct Row {
    std::uint32_t uid;
    const char* name;
    const char* parameters;
    const char* returns;
  };
  for (const Row& row : std::vector<Row>{{113, "wakeUp", "()", "v"},
                                         {123, "stiffnessInterpolation", "(mmm)", "v"},
                                         {127, "angleInterpolation", "(mmmb)", "v"},
                                         {129, "angleInterpolationBezier", "([s]mm)", "v"},
                                         {130, "setAngles", "(mmf)", "v"},
                                         {132, "getAngles", "(mb)", "[f]"},
                                         {141, "setWalkTargetVelocity", "(ffffmm)", "v"},
                                         {146, "moveTo", "(ffffm)", "v"},
                                         {147, "moveTo", "(m)", "v"},
                                         {169, "getFootSteps", "()", "m"},
                                         {195, "getPosition", "(sib)", "[f]"},
                                         {245, "setFallManagerEnabled", "(b)", "v"},
                                         {255, "getBodyNames", "(s)", "[s]"},
                                         {257, "getLimits", "(s)", "m"},
                                         {284, "getTaskList", "()", "m"},
                                         {290, "killAll", "()", "v"}}) {
    const rpc::Method* method = motion->findMethod(row.uid);
    ASSERT_NE(method, nullptr) << row.uid;
    EXPECT_EQ(method->name, row.name);
    EXPECT_EQ(method->parameters_signature, row.parameters);
    EXPECT_EQ(method->return_signature, row.returns);
  }
}

TEST_F(AlMotionAnglesTest, SetAnglesTakesEveryShape) {
  call("setAngles", {"HeadYaw", 0.5F, 1.0F});
  call("setAngles", {list({"HeadPitch", "LElbowYaw"}), list({0.2F, -1}), 1});  // ints too
  call("setAngles", {"RElbowYaw", list({1.25}), 1.0F});
  call("setAngles", {list({"LShoulderRoll"}), 1, 1.0F});
  bench.run(1);
  EXPECT_NEAR(angle("HeadYaw"), 0.5, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), 0.2, kFloat);
  EXPECT_NEAR(angle("LElbowYaw"), -1, kFloat);
  EXPECT_NEAR(angle("RElbowYaw"), 1.25, kFloat);
  EXPECT_NEAR(angle("LShoulderRoll"), 1, kFloat);
}

TEST_F(AlMotionAnglesTest, SetAnglesTakesAChainAndASpeedPerJoint) {
  call("setAngles", {"Head", list({0.5F, 0.1F}), list({1.0F, 0.1F})});
  bench.run(0.1);
  EXPECT_NEAR(angle("HeadYaw"), 0.5, kFloat);
  bench.run(0.5);
  EXPECT_NEAR(angle("HeadPitch"), 0.1, kFloat);
}

TEST_F(AlMotionAnglesTest, ChangeAnglesAdds) {
  call("changeAngles", {"LShoulderPitch", -0.5F, 1.0F});
  bench.run(1);
  EXPECT_NEAR(angle("LShoulderPitch"), 1.1, kFloat);
}

TEST_F(AlMotionAnglesTest, BodyHasTwentyTwoAngles) {
  const auto names = call("getBodyNames", {"Body"}).to<std::vector<std::string>>();
  const auto angles = call("getAngles", {"Body", true}).to<Floats>();
  ASSERT_EQ(angles.size(), 22u);
  ASSERT_EQ(names.size(), 22u);
  EXPECT_EQ(names[12], "RHipYawPitch");
  EXPECT_FLOAT_EQ(angles[12], angles[6]);  // one motor, listed twice
  EXPECT_FLOAT_EQ(angles[9], 2.11F);
}

TEST_F(AlMotionAnglesTest, AWholeBodyCanBeSetAndLeftWins) {
  std::vector<Value> targets(22, Value(0.05F));
  targets[6] = Value(-0.3F);  // LHipYawPitch
  targets[12] = Value(0.2F);  // RHipYawPitch
  call("setAngles", {"Body", list(targets), 1.0F});
  bench.run(1);
  EXPECT_NEAR(angle("RHipYawPitch"), -0.3, kFloat);
}

TEST_F(AlMotionAnglesTest, AnglesAreReadFromSensorsOrCommands) {
  bench.frame.angle[*bench.model->findJoint("HeadYaw")] = 0.3;
  bench.cycle();
  EXPECT_NEAR(call("getAngles", {"HeadYaw", true}).to<Floats>()[0], 0.3, kFloat);
  EXPECT_NEAR(call("getAngles", {list({"HeadYaw"}), false}).to<Floats>()[0], 0, kFloat);
}

TEST_F(AlMotionAnglesTest, AngleInterpolationTakesEveryShape) {
  call("angleInterpolation", {"HeadYaw", 0.5F, 0.2F, true});
  EXPECT_NEAR(angle("HeadYaw"), 0.5, kFloat);
  call("angleInterpolation", {"HeadYaw", list({0.1F, 0.4F}), list({0.1F, 1}), true});
  EXPECT_NEAR(angle("HeadYaw"), 0.4, kFloat);
  call("angleInterpolation", {"Head", list({0.3F, 0.1F}), 1, true});  // one time for all
  EXPECT_NEAR(angle("HeadYaw"), 0.3, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), 0.1, kFloat);
  call("angleInterpolation",
       {list({"HeadYaw", "HeadPitch"}), list({0.1F, 0.2F}), list({0.2F, 0.4F}), true});
  EXPECT_NEAR(angle("HeadPitch"), 0.2, kFloat);
  call("angleInterpolation",
       {list({"HeadYaw", "HeadPitch"}), list({list({0.5F, 0}), list({-0.1F})}),
        list({list({0.1F, 0.3F}), list({0.2F})}), true});
  EXPECT_NEAR(angle("HeadYaw"), 0, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), -0.1, kFloat);
  call("angleInterpolation",
       {list({"HeadYaw", "HeadPitch"}), list({list({0.5F, 0.2F}), list({0.1F, 0.3F})}),
        list({0.1F, 0.2F}), true});  // times shared by all
  EXPECT_NEAR(angle("HeadPitch"), 0.3, kFloat);
  call("angleInterpolation",
       {list({"HeadYaw", "HeadPitch"}), list({list({0.25F}), list({0.1F})}), 0.2F, true});
  EXPECT_NEAR(angle("HeadYaw"), 0.25, kFloat);
}

TEST_F(AlMotionAnglesTest, RelativeAnglesAdd) {
  call("angleInterpolation", {list({"HeadYaw"}), list({0.5F, 0.25F}), list({0.2F, 0.4F}), false});
  EXPECT_NEAR(angle("HeadYaw"), 0.25, kFloat);
  call("angleInterpolation", {"HeadYaw", 0.5F, 0.2F, false});
  EXPECT_NEAR(angle("HeadYaw"), 0.75, kFloat);
}

TEST_F(AlMotionAnglesTest, ABlockingCallEndsWithItsMotion) {
  const auto pending = motion->call("angleInterpolation", {"HeadYaw", 1.0F, 1.0F, true});
  bench.run(0.9);
  EXPECT_FALSE(pending.isDone());
  bench.run(0.15);
  EXPECT_TRUE(pending.isDone());
}

TEST_F(AlMotionAnglesTest, InterpolationWithSpeedArrives) {
  call("angleInterpolationWithSpeed", {list({"HeadYaw", "HeadPitch"}), list({0.5F, 0}), 0.5F});
  EXPECT_NEAR(angle("HeadYaw"), 0.5, kFloat);
  call("angleInterpolationWithSpeed", {"HeadYaw", 1, 1});
  EXPECT_NEAR(angle("HeadYaw"), 1, kFloat);
  call("angleInterpolationWithSpeed", {"HeadYaw", list({-0.5F}), 0.2F});
  EXPECT_NEAR(angle("HeadYaw"), -0.5, kFloat);
}

TEST_F(AlMotionAnglesTest, InterpolationWithSpeedTakesTheSwitchOf1xPrograms) {
  call("angleInterpolationWithSpeed", {"HeadYaw", 0.25F, 0.5F, true});
  EXPECT_NEAR(angle("HeadYaw"), 0.25, kFloat);
  EXPECT_EQ(errorOf("angleInterpolationWithSpeed", {"HeadYaw", 0.5F, 0.5F, false}),
            "\tALMotion::angleInterpolationWithSpeed\n\tisAbsolute must be true: give the angles "
            "to go to");
  EXPECT_NEAR(angle("HeadYaw"), 0.25, kFloat);
}

TEST_F(AlMotionAnglesTest, BezierTakesKeysWithAndWithoutHandles) {
  const Value key = list({0.5F, list({3, -0.1F, 0}), list({3, 0.1F, 0.0F})});
  call("angleInterpolationBezier",
       {list({"HeadYaw", "HeadPitch"}), list({list({0.2F, 0.4F}), list({0.3F})}),
        list({list({key, 0.1F}), list({list({0.2F})})})});
  EXPECT_NEAR(angle("HeadYaw"), 0.1, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), 0.2, kFloat);
}

TEST_F(AlMotionAnglesTest, BezierHandlesShapeTheWay) {
  // A handle that leaves the first key steeply carries the joint beyond the second key's angle.
  const Value up = list({0.0F, list({3, -0.1F, 0}), list({3, 0.3F, 1.5F})});
  const Value end = list({0.1F, list({3, -0.3F, 0.0F}), list({3, 0, 0})});
  motion->call("angleInterpolationBezier",
               {list({"HeadYaw"}), list({list({0.2F, 1.2F})}), list({list({up, end})})});
  double highest = 0;
  for (int i = 0; i < 130; ++i) {
    bench.cycle();
    highest = std::max(highest, bench.link.state()->command.angle[0]);
  }
  EXPECT_GT(highest, 0.4);
  EXPECT_NEAR(angle("HeadYaw"), 0.1, kFloat);
}

TEST_F(AlMotionAnglesTest, AnAnimationIsAbsoluteOrAddsToWhereJointsAre) {
  const Value names = list({"HeadYaw", "HeadPitch"});
  const Value times = list({list({0.2F, 0.4F}), list({0.3F})});
  const Value keys = list({list({0.5F, 0.1F}), list({0.2F})});
  call("animation", {names, times, keys, true, list({})});
  EXPECT_NEAR(angle("HeadYaw"), 0.1, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), 0.2, kFloat);
  call("animation", {names, times, keys, list({false, false}), list({})});
  EXPECT_NEAR(angle("HeadYaw"), 0.2, kFloat);
  EXPECT_NEAR(angle("HeadPitch"), 0.4, kFloat);
  EXPECT_EQ(errorOf("animation", {names, times, keys, list({false, true}), list({})}),
            "\tALMotion::animation\n\tjoints must be all absolute or all relative");
  EXPECT_EQ(errorOf("animation", {names, times, keys, list({true}), list({})}),
            "\tALMotion::animation\n\texpected one isAbsolute per joint, got 1 for 2 joints");
  EXPECT_EQ(errorOf("animation", {names, times, keys, true, list({"LLeg"})}),
            "\tALMotion::animation\n\ta support sequence is not simulated: expected []");
}

TEST_F(AlMotionAnglesTest, MistakesAreErrorsInNaoQisShape) {
  EXPECT_EQ(errorOf("setAngles", {"Elbow", 0.5F, 0.1F}),
            "\tALMotion::setAngles\n\tunknown joint or chain name: Elbow");
  EXPECT_EQ(errorOf("setAngles", {"HeadYaw", "fast", 0.1F}),
            "\tALMotion::setAngles\n\texpected a number, got \"fast\"");
  EXPECT_EQ(errorOf("setAngles", {"HeadYaw", 0.5F, 0.0F}),
            "\tALMotion::setAngles\n\tthe fraction of maximum speed must be above 0, up to 1");
  EXPECT_EQ(errorOf("setAngles", {"Head", list({1, 2, 3}), 0.1F}),
            "\tALMotion::setAngles\n\texpected one value per joint, got 3 values for 2 joints");
  EXPECT_EQ(errorOf("setAngles", {"HeadYaw", std::nan(""), 0.1F}),
            "\tALMotion::setAngles\n\texpected a finite number");
  EXPECT_EQ(errorOf("angleInterpolation", {"HeadYaw", list({1, 0}), list({1, 0.5F}), true}),
            "\tALMotion::angleInterpolation\n\ttimes must be positive and ascending");
  EXPECT_EQ(errorOf("angleInterpolation", {"HeadYaw", list({1, 0}), 1, true}),
            "\tALMotion::angleInterpolation\n\texpected one time per angle, got 1 time for 2 "
            "angles");
  EXPECT_EQ(errorOf("angleInterpolation", {"Head", list({list({1, 0})}), 1, true}),
            "\tALMotion::angleInterpolation\n\texpected one list of angles per joint, got 1 list "
            "for 2 joints");
  EXPECT_EQ(errorOf("angleInterpolationBezier",
                    {list({"HeadYaw"}), list({list({1})}), list({list({list({1, 2})})})}),
            "\tALMotion::angleInterpolationBezier\n\texpected a handle [type, dTime, dAngle]");
  EXPECT_EQ(errorOf("openHand", {"HeadYaw"}), "\tALMotion::openHand\n\tunknown hand name: HeadYaw");
}

TEST_F(AlMotionAnglesTest, CancelingACallStopsTheJoint) {
  const auto pending = motion->call("angleInterpolation", {"HeadYaw", 1.0F, 2.0F, true});
  bench.run(1);
  pending.cancel();
  EXPECT_TRUE(pending.outcome()->isCanceled());
  bench.run(0.02);
  const double stopped = angle("HeadYaw");
  bench.run(0.5);
  EXPECT_DOUBLE_EQ(angle("HeadYaw"), stopped);
  EXPECT_LT(stopped, 0.6);
}

TEST(AlMotionHands, OpenThenGoLimp) {
  auto robot = motion::makeTestRobot();
  Actuator hand;
  hand.name = "LHand";
  hand.upper = 1;
  hand.max_velocity = 8.33;
  robot->actuators.push_back(hand);
  for (Posture& posture : robot->postures) {
    JointArray<double> angle(robot->jointCount());
    for (std::size_t i = 0; i < posture.angle.size(); ++i) angle[i] = posture.angle[i];
    posture.angle = angle;
  }
  RobotBench bench(robot);
  bench.cycle();
  const auto motion = makeAlMotion(bench.link);
  bench.call(*motion, "openHand", {"LHand"});
  EXPECT_NEAR(bench.call(*motion, "getAngles", {"LHand", true}).to<Floats>()[0], 1, kFloat);
  EXPECT_EQ(bench.call(*motion, "getStiffnesses", {"LHand"}).to<Floats>()[0], 0);
  bench.call(*motion, "closeHand", {"LHand"});
  EXPECT_NEAR(bench.call(*motion, "getAngles", {"LHand", true}).to<Floats>()[0], 0, kFloat);
}

}  // namespace
}  // namespace nao::services
