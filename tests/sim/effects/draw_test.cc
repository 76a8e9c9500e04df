#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "sim/world.h"
#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kDegree = M_PI / 180;

World standing(std::uint64_t seed, const std::string& robot = "nao_h21_v33") {
  WorldOptions options(2ms);
  options.seed = seed;
  return World(nao::test::flatWorld(), {{"nao", nao::test::robot(robot), {}}}, options);
}

TEST(Draw, IsEmptyWithoutASeedAndForTheIdealRobot) {
  EXPECT_TRUE(standing(0).draw().empty());
  EXPECT_TRUE(standing(7, "nao_h21_v33_ideal").draw().empty());
}

TEST(Draw, ListsEveryJointAndWhatElseTheRunHasDrawn) {
  const auto draw = standing(7).draw();
  const auto model = nao::test::robot("nao_h21_v33");
  std::set<std::string> expected{"nao.start_pose.x", "nao.start_pose.y", "nao.start_pose.theta",
                                 "nao.floor_friction.friction"};
  for (const Actuator& motor : model->actuators) expected.insert("nao.joint_zero." + motor.name);
  std::set<std::string> listed;
  for (const auto& [name, value] : draw) listed.insert(name);
  EXPECT_EQ(listed, expected);
}

TEST(Draw, IsTheSameForTheSameSeedAndAnotherForAnother) {
  EXPECT_EQ(standing(7).draw(), standing(7).draw());
  EXPECT_NE(standing(7).draw(), standing(8).draw());
}

TEST(Draw, FollowsItsLaws) {
  double zero_square = 0, place_square = 0, turn_square = 0;
  int zeros = 0;
  double least = 1, most = 0;
  constexpr int kRuns = 300;
  const auto model = nao::test::robot("nao_h21_v33");
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    const EffectChain chain = chainOf(*model, model->variation, seed);
    for (const auto& [name, value] : chain.draw()) {
      if (name.rfind("joint_zero", 0) == 0) {
        zero_square += value * value;
        ++zeros;
      }
    }
    const auto draw = chain.draw();
    place_square += std::pow(draw.at("start_pose.x"), 2) + std::pow(draw.at("start_pose.y"), 2);
    turn_square += std::pow(draw.at("start_pose.theta"), 2);
    least = std::min(least, draw.at("floor_friction.friction"));
    most = std::max(most, draw.at("floor_friction.friction"));
  }
  // A standard deviation from n draws is known to 1 / sqrt(2 n); five of these.
  EXPECT_NEAR(std::sqrt(zero_square / zeros), 0.3 * kDegree,
              0.3 * kDegree * 5 / std::sqrt(2.0 * zeros));
  EXPECT_NEAR(std::sqrt(place_square / (2 * kRuns)), 0.002, 0.002 * 5 / std::sqrt(4.0 * kRuns));
  EXPECT_NEAR(std::sqrt(turn_square / kRuns), 0.5 * kDegree,
              0.5 * kDegree * 5 / std::sqrt(2.0 * kRuns));
  EXPECT_GE(least, 0.5);
  EXPECT_LE(most, 0.8);
  EXPECT_LT(least, 0.51);  // 300 draws miss one thirtieth of the range once in 25,000 times
  EXPECT_GT(most, 0.79);
}

TEST(JointZero, MovesTheJointByWhatItListsAndNotItsReading) {
  auto model = std::make_shared<RobotModel>(*nao::test::pendulum(0.5, 0.2));
  model->variation = {effect("joint_zero", {{"sd", 0.05}})};
  auto world_model = nao::test::flatWorld();
  world_model->gravity = 0;
  WorldOptions options(2ms);
  options.seed = 3;
  World world(world_model, {{"dut", model, {}}}, options);
  for (int i = 0; i < 500; ++i) {
    world.setCommand(0, {JointArray<double>(1, 0.2), JointArray<double>(1, 1.0)});
    world.step();
  }
  const Mat3 R = world.scene().robots[0].X_WB[1].linear();
  const double angle = std::atan2(R(0, 2), R(0, 0));
  const double drawn = world.draw().at("dut.joint_zero.hinge");
  EXPECT_GT(std::abs(drawn), 1e-3);
  EXPECT_NEAR(world.readSensors(0).angle[0], 0.2, 1e-6);
  EXPECT_NEAR(angle, 0.2 + drawn, 1e-6);
}

TEST(StartPose, MovesWhereTheRobotStartsByWhatItLists) {
  World world = standing(5);
  World ideal = standing(0);
  const auto draw = world.draw();
  const Pose X = world.scene().robots[0].X_WB[0];
  const Pose X_ideal = ideal.scene().robots[0].X_WB[0];
  // The lean of the start posture turns with the robot: second order in the draw.
  EXPECT_NEAR(X.translation().x() - X_ideal.translation().x(), draw.at("nao.start_pose.x"), 1e-9);
  EXPECT_NEAR(X.translation().y() - X_ideal.translation().y(), draw.at("nao.start_pose.y"), 1e-9);
}

TEST(Draw, MassSpreadChangesEveryBodyWithinItsPart) {
  constexpr double kPart = 0.05;
  auto model = std::make_shared<RobotModel>(*nao::test::robot("nao_h21_v33_ideal"));
  model->variation = {{"mass_spread", {{"part", kPart}}, {}, "test"}};
  double least = 2, most = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    BodyPlan plan(*model, *nao::test::flatWorld());
    EffectChain chain = chainOf(*model, model->variation, seed);
    chain.alterPlan(plan);
    for (std::size_t b = 0; b < model->bodies.size(); ++b) {
      const double factor = plan.model.bodies[b].mass / model->bodies[b].mass;
      EXPECT_NEAR(factor, chain.draw().at("mass_spread." + model->bodies[b].name), 1e-12);
      least = std::min(least, factor);
      most = std::max(most, factor);
    }
  }
  EXPECT_GE(least, 1 - kPart);
  EXPECT_LT(least, 1 - 0.98 * kPart);
  EXPECT_LE(most, 1 + kPart);
  EXPECT_GT(most, 1 + 0.98 * kPart);
}

}  // namespace
}  // namespace nao::sim::test
