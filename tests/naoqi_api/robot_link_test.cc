#include "naoqi_api/robot_link.h"

#include <gtest/gtest.h>

#include "tests/naoqi_api/services/robot_bench.h"

namespace nao::services {
namespace {

motion::Interpolate turnHead(const RobotModel& model, double seconds) {
  motion::Key key;
  key.time = seconds;
  key.angle = 1;
  motion::Interpolate request;
  request.curves.push_back({*model.findJoint("HeadYaw"), {key}});
  return request;
}

TEST(RobotLink, EndsACallWhenTheMotionEnds) {
  RobotBench bench;
  const auto call = bench.link.postAndWait(turnHead(*bench.model, 0.5));
  bench.run(0.49);
  EXPECT_FALSE(call.isDone());
  bench.run(0.02);
  ASSERT_TRUE(call.isDone());
  EXPECT_TRUE(call.outcome()->value);
}

TEST(RobotLink, AFailureIsTheErrorOfTheCall) {
  RobotBench bench;
  const auto call = bench.link.postAndWait(motion::GoToPosture{"Handstand", 1});
  bench.cycle();
  ASSERT_TRUE(call.isDone());
  EXPECT_EQ(call.outcome()->error, "unknown posture Handstand");
}

TEST(RobotLink, AKilledMotionEndsItsCallWithoutAnError) {
  RobotBench bench;
  const auto call = bench.link.postAndWait(turnHead(*bench.model, 5));
  bench.run(0.1);
  bench.link.post(motion::KillAll{});
  bench.cycle();
  ASSERT_TRUE(call.isDone());
  EXPECT_TRUE(call.outcome()->value);
}

TEST(RobotLink, CancelingACallKillsTheMotion) {
  RobotBench bench;
  const auto call = bench.link.postAndWait(turnHead(*bench.model, 5));
  bench.run(0.1);
  EXPECT_EQ(bench.link.state()->tasks.size(), 1u);
  call.cancel();
  EXPECT_TRUE(call.outcome()->isCanceled());
  bench.cycle();
  EXPECT_TRUE(bench.link.state()->tasks.empty());
}

TEST(RobotLink, SaysBusyWhenTheRobotTakesNoMore) {
  RobotBench bench;
  int posted = 0;
  EXPECT_THROW(
      {
        for (; posted < 5000; ++posted) bench.link.post(motion::StopMove{});
      },
      rpc::CallError);
  EXPECT_EQ(posted, 1024);
  bench.cycle();
  EXPECT_EQ(bench.link.post(motion::StopMove{}), 1025u);  // no number was lost
}

TEST(RobotLink, AReaderWaitsForItsOwnWrites) {
  RobotBench bench;
  bench.cycle();
  bench.link.post(motion::SetStiffness{{bench.model->findJoint("HeadYaw").value()}, {0.7}});
  const auto read =
      bench.link.whenSettled([&] { return bench.link.state()->command.stiffness[0]; });
  EXPECT_FALSE(read.isDone());
  bench.cycle();
  ASSERT_TRUE(read.isDone());
  EXPECT_DOUBLE_EQ(*read.outcome()->value, 0.7);
  const auto again = bench.link.whenSettled([] { return 1; });
  EXPECT_TRUE(again.isDone());  // nothing to wait for
}

TEST(RobotLink, AnErrorWhileReadingIsTheErrorOfTheCall) {
  RobotBench bench;
  bench.cycle();
  const auto read =
      bench.link.whenSettled([]() -> int { throw rpc::CallError("nothing to read"); });
  EXPECT_EQ(read.outcome()->error, "nothing to read");
}

TEST(RobotLink, ReadersBeforeTheFirstCycleThrow) {
  RobotBench bench;
  EXPECT_THROW(bench.link.sensors(), rpc::CallError);
  EXPECT_THROW(bench.link.state(), rpc::CallError);
  EXPECT_EQ(toSeconds(bench.link.now()), 0);
}

TEST(RobotLink, WaitsForAState) {
  RobotBench bench;
  bench.cycle();
  const auto later = bench.link.until(
      [](const motion::MotionState& state) { return toSeconds(state.time) > 0.095; });
  bench.run(0.05);
  EXPECT_FALSE(later.isDone());
  bench.run(0.1);
  EXPECT_TRUE(later.isDone());
}

TEST(RobotLink, AWaitThatIsCanceledIsForgotten) {
  RobotBench bench;
  bench.cycle();
  int asked = 0;
  const auto wait = bench.link.until([&](const motion::MotionState& /*state*/) {
    ++asked;
    return false;
  });
  bench.cycle();
  EXPECT_EQ(asked, 2);
  wait.cancel();
  bench.run(0.1);
  EXPECT_EQ(asked, 2);
}

TEST(RobotLink, AWaitWhoseClientHasGoneIsForgottenAMotionGoesOn) {
  RobotBench bench;
  bench.cycle();
  int asked = 0;
  const auto wait = bench.link.until([&](const motion::MotionState& /*state*/) {
    ++asked;
    return false;
  });
  const auto call = bench.link.postAndWait(turnHead(*bench.model, 0.5));
  wait.abandon();
  call.abandon();
  bench.run(0.1);
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(bench.link.state()->tasks.size(), 1u);
  bench.run(0.5);
  EXPECT_TRUE(call.outcome()->value);
}

TEST(RobotLink, WaitsFailAndDelaysStayWhenTimeIsSetBack) {
  RobotBench bench;
  bench.run(1);
  const auto wait = bench.link.until([](const motion::MotionState& /*state*/) { return false; });
  bool fired = false;
  bench.link.after(std::chrono::milliseconds(100), [&] { fired = true; });
  bench.run(0.05);
  motion::MotionState back = *bench.link.state();
  back.time = {};
  back.set_back = 1;
  bench.frame.time = {};
  bench.ports->state.publish(back);
  const auto later = bench.link.until([](const motion::MotionState& s) { return s.fallen; });
  bench.link.deliver();
  ASSERT_TRUE(wait.isDone());
  EXPECT_EQ(wait.outcome()->error, "the simulation was set back to a snapshot");
  EXPECT_FALSE(later.isDone());  // asked after it
  EXPECT_FALSE(fired);
  back.time += std::chrono::milliseconds(49);
  bench.ports->state.publish(back);
  bench.link.deliver();
  EXPECT_FALSE(fired);
  back.time += std::chrono::milliseconds(1);
  bench.ports->state.publish(back);
  bench.link.deliver();
  EXPECT_TRUE(fired);
}

TEST(RobotLink, TimersFireInOrderOfSimulatedTime) {
  RobotBench bench;
  bench.cycle();
  std::string order;
  bench.link.after(std::chrono::milliseconds(50), [&] { order += 'b'; });
  bench.link.after(std::chrono::milliseconds(20), [&] {
    order += 'a';
    bench.link.after(std::chrono::milliseconds(10), [&] { order += 'c'; });
  });
  bench.link.after(std::chrono::milliseconds(50), [&] { order += 'd'; });
  const auto gone = bench.link.after(std::chrono::milliseconds(10), [&] { order += 'x'; });
  bench.link.cancelTimer(gone);
  bench.run(0.02);
  EXPECT_EQ(order, "a");
  bench.run(0.01);
  EXPECT_EQ(order, "ac");
  bench.run(0.05);
  EXPECT_EQ(order, "acbd");
}

}  // namespace
}  // namespace nao::services
