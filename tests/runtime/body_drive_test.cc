// A program that drives the body past the motion side, and how the motion side makes room.
#include <gtest/gtest.h>

#include <limits>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

class BodyDriveTest : public testing::Test {
 protected:
  motion::RobotPorts& ports() { return *simulation_.robot(0).ports(); }
  motion::MotionState state() { return *ports().state.get(); }
  double stiffness() { return state().command.stiffness[yaw_]; }
  void runFor(Duration time) { simulation_.advanceTo(simulation_.now() + time); }

  void command(double angle, double stiffness) {
    BodyCommand command;
    command.number = ++number_;
    command.angle = JointArray<double>(joints_, std::numeric_limits<double>::quiet_NaN());
    command.angle[yaw_] = angle;
    command.stiffness = JointArray<double>(joints_, stiffness);
    ports().body.publish(command);
  }
  void request(motion::MotionAction action) {
    ASSERT_TRUE(ports().requests.post({++request_, std::move(action)}));
  }
  /// How the request posted last ended.
  motion::MotionOutcome outcome() {
    for (const auto& ended : ports().outcomes.drain()) {
      if (ended.id == request_) return ended;
    }
    ADD_FAILURE() << "it has not ended";
    return {};
  }

  Simulation simulation_{test::flatWorld(), {{"nao", test::robot("nao_h25_v60"), {}}}, 2ms};
  std::size_t joints_ = simulation_.robot(0).model().jointCount();
  Joint yaw_ = simulation_.robot(0).model().findJoint("HeadYaw").value();
  std::uint64_t number_ = 0;
  motion::RequestId request_ = 0;
};

TEST_F(BodyDriveTest, AJointGoesWhereItIsTold) {
  for (int cycle = 0; cycle < 100; ++cycle) {
    command(0.5, 1);
    runFor(12ms);
  }
  // As near as a servo holds a head that nothing pulls aside.
  EXPECT_NEAR(ports().sensors.get()->angle[yaw_], 0.5, 0.02);
  EXPECT_TRUE(state().driven);
  EXPECT_EQ(state().command.angle[yaw_], 0.5);
}

TEST_F(BodyDriveTest, TheLastCommandHoldsHalfASecondAndThenTheBodyIsLimp) {
  command(0.5, 1);
  runFor(12ms);  // taken at the cycle at 0
  EXPECT_EQ(stiffness(), 1);
  runFor(492ms);  // the last cycle was at 492 ms
  EXPECT_EQ(stiffness(), 1);
  runFor(12ms);  // and now at 504 ms
  EXPECT_EQ(stiffness(), 0);
  EXPECT_FALSE(state().driven);
  command(0.5, 1);
  runFor(12ms);
  EXPECT_EQ(stiffness(), 1);  // who comes back drives again
}

TEST_F(BodyDriveTest, CommandsAreKeptWithinLimits) {
  command(3, 1);
  runFor(12ms);
  EXPECT_EQ(state().command.angle[yaw_], simulation_.robot(0).model().actuators[index(yaw_)].upper);
}

TEST_F(BodyDriveTest, TheFirstCommandEndsMotionsAndLaterOnesFail) {
  request(motion::WakeUp{});
  runFor(24ms);
  ports().outcomes.drain();
  request(motion::GoToPosture{"StandInit", 0.5});
  runFor(240ms);
  command(0, 0.25);
  runFor(12ms);
  EXPECT_EQ(outcome().kind, motion::MotionOutcome::Kind::Failed);
  EXPECT_EQ(stiffness(), 0.25);
  request(motion::WakeUp{});
  runFor(24ms);
  const auto refused = outcome();
  EXPECT_EQ(refused.kind, motion::MotionOutcome::Kind::Failed);
  EXPECT_EQ(refused.reason, "a LoLA client drives the robot's body");
  EXPECT_EQ(state().last_accepted, request_);  // so that nobody waits for it
  EXPECT_EQ(stiffness(), 0.25);
}

TEST_F(BodyDriveTest, TheMotionSideDrivesAgainOnceItIsSilent) {
  command(0, 1);
  runFor(600ms);
  request(motion::WakeUp{});
  runFor(8000ms);  // it stands up from its crouch
  EXPECT_EQ(outcome().kind, motion::MotionOutcome::Kind::Done);
  EXPECT_GT(stiffness(), 0);
}

TEST_F(BodyDriveTest, ASnapshotKeepsWhoDrives) {
  command(0.5, 1);
  runFor(120ms);
  const auto driven = simulation_.snapshot();
  const std::uint64_t hash = simulation_.hash();
  runFor(600ms);
  EXPECT_FALSE(state().driven);
  simulation_.restore(*driven);
  EXPECT_EQ(simulation_.hash(), hash);
  EXPECT_TRUE(state().driven);
  EXPECT_EQ(stiffness(), 1);
  runFor(600ms);
  EXPECT_FALSE(state().driven);
}

TEST_F(BodyDriveTest, EveryCycleIsToldBeforeTheWorldMovesOn) {
  Simulation simulation{test::flatWorld(), {{"nao", test::robot("nao_h25_v60"), {}}}, 2ms};
  std::vector<SimTime> told;
  simulation.tellCycles(0, [&](const SensorFrame& frame, const JointCommand& command) {
    told.push_back(frame.time);
    EXPECT_EQ(simulation.now(), frame.time);
    EXPECT_EQ(command.stiffness.size(), joints_);
  });
  simulation.advanceTo(SimTime(36ms));
  EXPECT_EQ(told, (std::vector<SimTime>{SimTime(0ms), SimTime(12ms), SimTime(24ms)}));
}

}  // namespace
}  // namespace nao::runtime
