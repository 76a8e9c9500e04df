#include "runtime/simulation.h"

#include <gtest/gtest.h>

#include "runtime/ground_truth.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

Simulation simulationWith(std::vector<const char*> models) {
  std::vector<sim::RobotSetup> robots;
  for (const char* model : models) {
    robots.push_back({"robot" + std::to_string(robots.size()),
                      test::robot(model),
                      {0, -0.8 * static_cast<double>(robots.size()), 0}});
  }
  return {test::flatWorld(), robots, 2ms};
}

/// Posts, and advances until the robot says how it ended; Killed if it never does.
motion::MotionOutcome ask(Simulation& simulation, std::size_t robot, motion::MotionRequest request,
                          Duration patience = 20000ms) {
  motion::RobotPorts& ports = *simulation.robot(robot).ports();
  EXPECT_TRUE(ports.requests.post(request));
  for (const SimTime end = simulation.now() + patience; simulation.now() < end;) {
    simulation.advanceTo(simulation.now() + 10ms);
    for (const motion::MotionOutcome& outcome : ports.outcomes.drain()) {
      if (outcome.id == request.id) return outcome;
    }
  }
  return {request.id, motion::MotionOutcome::Kind::Killed, "never ended"};
}

Pose2 truePose(const Simulation& simulation, std::size_t robot) {
  const auto scene = simulation.truth().get();
  return calcFloorPose(*scene->robots[robot].model, scene->robots[robot].X_WB);
}

TEST(Simulation, PublishesFramesOncePerCycle) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  const auto& ports = *simulation.robot(0).ports();
  simulation.advanceTo(SimTime(2ms));
  EXPECT_EQ(ports.sensors.get()->time, SimTime(0ms));
  simulation.advanceTo(SimTime(10ms));
  EXPECT_EQ(ports.sensors.get()->time, SimTime(0ms));  // the frame of 10 ms comes with its step
  simulation.advanceTo(SimTime(12ms));
  EXPECT_EQ(ports.sensors.get()->time, SimTime(10ms));
}

TEST(Simulation, ARobotStartsLimpInCrouch) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  simulation.advanceTo(SimTime(1000ms));
  const auto state = simulation.robot(0).ports()->state.get();
  for (const double stiffness : state->command.stiffness) EXPECT_LE(stiffness, 0);
  EXPECT_FALSE(state->awake);
  const auto frame = simulation.robot(0).ports()->sensors.get();
  EXPECT_GT(frame->angle[*test::robot("nao_h21_v33")->findJoint("LKneePitch")], 1.9);
}

TEST(Simulation, WakesUpAndRestsOnItsFeet) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  EXPECT_EQ(ask(simulation, 0, {1, motion::WakeUp{}}).kind, motion::MotionOutcome::Kind::Done);
  EXPECT_GT(simulation.truth().get()->robots[0].X_WB[0].translation().z(), 0.3);
  EXPECT_EQ(ask(simulation, 0, {2, motion::Rest{}}).kind, motion::MotionOutcome::Kind::Done);
  EXPECT_LT(simulation.truth().get()->robots[0].X_WB[0].translation().z(), 0.26);
  for (const double stiffness : simulation.robot(0).ports()->state.get()->command.stiffness) {
    EXPECT_LE(stiffness, 0);
  }
}

TEST(Simulation, SeveralRobotsWalkInOneWorld) {
  Simulation simulation = simulationWith({"nao_h21_v33", "nao_h25_v50"});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(simulation.robot(i).ports()->requests.post({1, motion::WakeUp{}}));
  }
  simulation.advanceTo(simulation.now() + 5000ms);
  const Pose2 before[2] = {truePose(simulation, 0), truePose(simulation, 1)};
  EXPECT_TRUE(simulation.robot(1).ports()->requests.post({2, motion::MoveTo{{0.2, 0, 0}, {}, {}}}));
  EXPECT_EQ(ask(simulation, 0, {2, motion::MoveTo{{0.2, 0, 0}, {}, {}}}).kind,
            motion::MotionOutcome::Kind::Done);
  simulation.advanceTo(simulation.now() + 2000ms);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(truePose(simulation, i).x - before[i].x, 0.2, 0.03)
        << i;  // 15 %: it slips a little
    EXPECT_NEAR(truePose(simulation, i).y - before[i].y, 0.0, 0.03) << i;
  }
}

TEST(Simulation, TheSameRequestsGiveTheSameRunToTheLastBit) {
  std::uint64_t hash[2];
  for (std::uint64_t& h : hash) {
    Simulation simulation = simulationWith({"nao_h21_v33"});
    ask(simulation, 0, {1, motion::WakeUp{}});
    EXPECT_TRUE(simulation.robot(0).ports()->requests.post({2, motion::MoveToward{1, 0, 0.2, {}}}));
    simulation.advanceTo(SimTime(6000ms));
    h = simulation.world().hash();
  }
  EXPECT_EQ(hash[0], hash[1]);
}

TEST(Simulation, AResetEndsWhatWasUnderWay) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  ask(simulation, 0, {1, motion::WakeUp{}});
  auto& ports = *simulation.robot(0).ports();
  EXPECT_TRUE(ports.requests.post({2, motion::MoveTo{{1, 0, 0}, {}, {}}}));
  simulation.advanceTo(simulation.now() + 2000ms);
  EXPECT_TRUE(ports.outcomes.drain().empty());
  simulation.apply(ResetWorld{});
  const auto outcomes = ports.outcomes.drain();
  ASSERT_FALSE(outcomes.empty());
  EXPECT_EQ(outcomes.front().id, 2u);
  EXPECT_NE(outcomes.front().kind, motion::MotionOutcome::Kind::Done);
  simulation.advanceTo(simulation.now() + 500ms);
  EXPECT_FALSE(ports.state.get()->awake);
  EXPECT_EQ(ports.state.get()->last_accepted, 2u);  // who waits for that must not wait for ever
  EXPECT_NEAR(truePose(simulation, 0).x, 0, 0.02);
}

TEST(Simulation, PlacesWhatItIsToldAndRefusesWhatIsNotThere) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  simulation.apply(PlaceRobot{0, {1, 2, 0.5}});
  EXPECT_NEAR(truePose(simulation, 0).x, 1, 0.03);  // Crouch's soles are a little off the torso
  EXPECT_NEAR(truePose(simulation, 0).theta, 0.5, 0.05);
  EXPECT_THROW(simulation.apply(PlaceRobot{3, {}}), InputError);
  EXPECT_THROW(simulation.apply(PlaceBall{0, Vec3::Zero(), Vec3::Zero()}), InputError);
}

TEST(Simulation, AcceptsRequestsWhileTimeStands) {
  Simulation simulation = simulationWith({"nao_h21_v33"});
  simulation.advanceTo(SimTime(100ms));
  auto& ports = *simulation.robot(0).ports();
  EXPECT_TRUE(ports.requests.post({7, motion::StopMove{}}));
  simulation.acceptRequests();
  EXPECT_EQ(ports.state.get()->last_accepted, 7u);
  EXPECT_EQ(simulation.now(), SimTime(100ms));
}

}  // namespace
}  // namespace nao::runtime
