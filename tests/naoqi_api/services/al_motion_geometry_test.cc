#include <gtest/gtest.h>

#include "naoqi_api/services/al_motion.h"
#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using Floats = std::vector<float>;

// A real robot: geometry needs its bodies.
class AlMotionGeometryTest : public testing::Test {
 protected:
  AlMotionGeometryTest() { bench.cycle(); }
  Floats floats(const std::string& name, const std::vector<Value>& arguments) {
    return bench.call(*motion, name, arguments).to<Floats>();
  }

  RobotBench bench{loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33")};
  std::shared_ptr<rpc::Service> motion = makeAlMotion(bench.link);
};

TEST_F(AlMotionGeometryTest, TheTorsoIsWhereItIs) {
  EXPECT_EQ(floats("getPosition", {"Torso", 0, false}), Floats(6, 0));
  const Floats in_robot = floats("getPosition", {"Torso", 2, true});
  EXPECT_GT(in_robot[2], 0.15F);  // a crouching Nao's torso is 0.2 m up
  EXPECT_LT(in_robot[2], 0.30F);
}

TEST_F(AlMotionGeometryTest, StandingUpRaisesTheTorso) {
  const float before = floats("getPosition", {"Torso", 1, false})[2];
  bench.call(*motion, "wakeUp", {});
  EXPECT_GT(floats("getPosition", {"Torso", 1, false})[2], before + 0.05F);
}

TEST_F(AlMotionGeometryTest, TransformsAreRowsOfTheSamePlace) {
  const Floats matrix = floats("getTransform", {"LArm", 2, true});
  const Floats position = floats("getPosition", {"LArm", 2, true});
  ASSERT_EQ(matrix.size(), 16u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FLOAT_EQ(matrix[4 * i + 3], position[i]);
  EXPECT_EQ(matrix[15], 1);
}

TEST_F(AlMotionGeometryTest, MassesAddUp) {
  const auto massOf = [&](const char* name) {
    return static_cast<double>(bench.call(*motion, "getMass", {name}).to<float>());
  };
  double sum = massOf("Torso");
  for (const char* chain : {"Head", "LArm", "RArm", "LLeg", "RLeg"}) sum += massOf(chain);
  EXPECT_NEAR(massOf("Body"), sum, 1e-4);
  EXPECT_NEAR(massOf("Body"), 4.88, 0.1);  // [kg] nao_spec
}

TEST_F(AlMotionGeometryTest, TheSupportPolygonLiesAroundTheFeetThatStand) {
  bench.call(*motion, "wakeUp", {});
  const auto corners = [&](bool by_sensors) {
    return bench.call(*motion, "getSupportPolygon", {2, by_sensors})
        .to<std::vector<std::vector<float>>>();
  };
  const auto both = corners(false);
  ASSERT_GE(both.size(), 4u);
  float left = 0, right = 0;
  for (const auto& corner : both) {
    ASSERT_EQ(corner.size(), 2u);
    left = std::max(left, corner[1]);
    right = std::min(right, corner[1]);
  }
  EXPECT_NEAR(left, 0.10F, 0.015F);  // [m] the outer edges of a standing Nao's feet
  EXPECT_NEAR(right, -0.10F, 0.015F);
  bench.call(*motion, "angleInterpolation", {"LKneePitch", 1.2F, 1.0F, true});
  for (const auto& corner : corners(false)) EXPECT_LT(corner[1], 0.0F);  // of the right foot alone
}

TEST_F(AlMotionGeometryTest, TheCentreOfMassIsAboveTheFeet) {
  bench.call(*motion, "wakeUp", {});
  const Floats com = floats("getCOM", {"Body", 2, false});
  ASSERT_EQ(com.size(), 3u);
  EXPECT_NEAR(com[1], 0, 0.005);
  EXPECT_GT(com[0], -0.04F);  // within the soles
  EXPECT_LT(com[0], 0.09F);
  EXPECT_GT(com[2], 0.2F);
}

TEST_F(AlMotionGeometryTest, FootStepsTellWhereTheFeetAre) {
  const Value steps = bench.call(*motion, "getFootSteps", {});
  ASSERT_EQ(steps.findItems()->size(), 3u);
  const auto& feet = *(*steps.findItems())[0].findItems();
  EXPECT_NEAR(feet[0].to<Floats>()[1], 0.05, 0.02);
  EXPECT_NEAR(feet[1].to<Floats>()[1], -0.05, 0.02);
}

TEST_F(AlMotionGeometryTest, UnknownPlacesAreErrors) {
  EXPECT_EQ(bench.errorOf(*motion, "getPosition", {"Tail", 0, true}),
            "\tALMotion::getPosition\n\tunknown chain, joint or sensor name: Tail");
  EXPECT_EQ(bench.errorOf(*motion, "getMass", {"Tail"}),
            "\tALMotion::getMass\n\tunknown chain or joint name: Tail");
}

TEST_F(AlMotionGeometryTest, SensedPositionKnowsThatALegLags) {
  bench.call(*motion, "wakeUp", {});
  const Floats commanded = floats("getRobotPosition", {false});
  const Floats arrived = floats("getRobotPosition", {true});
  EXPECT_NEAR(arrived[0], commanded[0], 1e-6);
  bench.frame.feet[1].total = 0;  // it stands on its left leg; the right one is behind its command
  bench.frame.angle[*bench.model->findJoint("RHipPitch")] += 0.2;
  bench.cycle();
  const Floats sensed = floats("getRobotPosition", {true});
  EXPECT_LT(sensed[0],
            commanded[0] - 0.015F);  // half of 0.2 rad on a leg of 0.25 m, at least 15 mm
  EXPECT_GT(sensed[0], commanded[0] - 0.03F);
  EXPECT_NEAR(sensed[1], commanded[1], 0.005);
}

}  // namespace
}  // namespace nao::services
