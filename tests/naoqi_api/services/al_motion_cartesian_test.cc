#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Floats = std::vector<float>;

class AlMotionCartesianTest : public testing::Test {
 protected:
  AlMotionCartesianTest() {
    bench.cycle();
    bench.call(*motion, "wakeUp", {});
  }
  Floats position(const char* name) {
    return bench.call(*motion, "getPosition", {name, 2, false}).to<Floats>();
  }
  static Value six(float x, float y, float z) { return Value::list({x, y, z, 0.F, 0.F, 0.F}); }

  RobotBench bench{loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33")};
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
};

TEST_F(AlMotionCartesianTest, OnePositionOrAListOfThemMovesAnArm) {
  const Floats start = position("LArm");
  bench.call(*motion, "positionInterpolation", {"LArm", 2, six(0, 0, 0.03F), 7, 0.5F, false});
  EXPECT_NEAR(position("LArm")[2], start[2] + 0.03F, 0.001);
  bench.call(*motion, "positionInterpolation",
             {"LArm", 2, Value::list({six(0, 0, -0.01F), six(0, 0, -0.03F)}), 7,
              Value::list({0.3F, 0.6F}), false});
  EXPECT_NEAR(position("LArm")[2], start[2], 0.001);
}

TEST_F(AlMotionCartesianTest, SeveralEffectorsMoveAtOnceToAbsolutePlaces) {
  Floats left = position("LArm");
  Floats right = position("RArm");
  left[2] += 0.02F;
  right[2] += 0.03F;
  const auto asList = [](const Floats& numbers) {
    return Value::list(std::vector<Value>(numbers.begin(), numbers.end()));
  };
  bench.call(*motion, "positionInterpolations",
             {Value::list({"LArm", "RArm"}), 2, Value::list({asList(left), asList(right)}),
              Value::list({7, 7}), Value::list({Value::list({0.5F}), Value::list({0.7F})})});
  EXPECT_NEAR(position("LArm")[2], left[2], 0.001);
  EXPECT_NEAR(position("RArm")[2], right[2], 0.001);
}

TEST_F(AlMotionCartesianTest, WhatDoesNotFitIsAnError) {
  const auto error = [&](const char* method, const std::vector<Value>& arguments) {
    return bench.errorOf(*motion, method, arguments);
  };
  EXPECT_NE(error("positionInterpolation", {"Tail", 2, six(0, 0, 0), 7, 1.F, false}), "");
  EXPECT_NE(error("positionInterpolation", {"LArm", 3, six(0, 0, 0), 7, 1.F, false}), "");
  EXPECT_NE(error("positionInterpolation", {"LArm", 2, six(0, 0, 0), 64, 1.F, false}), "");
  EXPECT_THAT(error("positionInterpolations",
                    {Value::list({"LArm"}), 2, six(0, 0, 0), Value::list({4e9}), 1.F, false}),
              testing::HasSubstr("no axis mask: 4e+09"));
  EXPECT_NE(error("positionInterpolation", {"LArm", 2, Value::list({1.F}), 7, 1.F, false}), "");
  EXPECT_NE(error("positionInterpolation", {"LArm", 2, six(0, 0, 0), 7, -1.F, false}), "");
  EXPECT_NE(error("wbFootState", {"Glued", "Legs"}), "");
  EXPECT_NE(error("wbSetEffectorControl", {"Head", Value::list({1.F})}), "");
}

TEST_F(AlMotionCartesianTest, ATrackersTargetTurnsTheHeadInTheRobotsFrame) {
  bench.call(*motion, "updateTrackerTarget", {0.2F, 0.5F, 40, false});
  bench.run(1);
  Floats head = position("Head");
  EXPECT_NEAR(head[4], 0.2, 1e-3);
  EXPECT_NEAR(head[5], 0.5, 1e-3);
  bench.call(*motion, "updateTrackerTarget", {0.0F, 0.0F, 40, true});  // no effector is enabled
  bench.run(1);
  EXPECT_NEAR(position("Head")[5], head[5], 1e-6);
  bench.call(*motion, "wbEnableEffectorControl", {"Head", true});
  bench.call(*motion, "updateTrackerTarget", {0.1F, -0.3F, 40, true});
  bench.run(3);
  head = position("Head");
  EXPECT_NEAR(head[4], 0.1, 0.02);
  EXPECT_NEAR(head[5], -0.3, 0.02);
}

TEST_F(AlMotionCartesianTest, GoToBalanceTellsWhetherItIsThere) {
  bench.call(*motion, "wbEnable", {true});
  bench.call(*motion, "wbFootState", {"Fixed", "Legs"});
  EXPECT_TRUE(bench.call(*motion, "wbGoToBalance", {"LLeg", 1.F}).to<bool>());
}

TEST_F(AlMotionCartesianTest, FootStepsReachTheGaitWithTheirPeriods) {
  const Value legs = Value::listOf("s", {"LLeg", "RLeg"});
  const Value steps =
      Value::list({Value::list({0.04F, 0.1F, 0.F}), Value::list({0.F, -0.1F, 0.2F})});
  bench.call(*motion, "setFootSteps", {legs, steps, Value::listOf("f", {0.6F, 1.1F}), true});
  bench.run(2);
  ASSERT_EQ(bench.gait->ordered.size(), 2u);
  EXPECT_EQ(bench.gait->ordered[1].foot, Foot::Right);
  EXPECT_NEAR(bench.gait->ordered[1].place.theta, 0.2, 1e-6);
  EXPECT_NEAR(bench.gait->ordered[1].period, 0.5, 1e-6);
  bench.call(*motion, "setFootStepsWithSpeed",
             {legs, steps, Value::listOf("f", {1.F, 0.5F}), false});
  EXPECT_NEAR(bench.gait->ordered[1].period, 0.51, 1e-6);
}

}  // namespace
}  // namespace nao::services
