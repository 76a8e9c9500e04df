#include "daemon/robot_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <limits>
#include <map>
#include <memory>
#include <thread>
#include <vector>

#include "tests/support/models.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;

class RobotLoopTest : public testing::Test {
 protected:
  /// Posts, and returns the number it will end under.
  std::uint64_t post(decltype(LoopRequest::action) action) {
    EXPECT_TRUE(loop_.post({++last_id_, std::move(action)}));
    return last_id_;
  }

  /// How a request ended; waits for it.
  std::string errorOf(std::uint64_t id) {
    while (ended_.count(id) == 0) {
      for (const LoopOutcome& outcome : loop_.outcomes().drain())
        ended_[outcome.id] = outcome.error;
    }
    return ended_[id];
  }

  runtime::Simulation simulation_{
      test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms};
  RobotLoop loop_{simulation_, 1e6, [] {}};
  std::map<std::uint64_t, std::string> ended_;
  std::uint64_t last_id_ = 0;
};

TEST_F(RobotLoopTest, StepsExactlyAsFarAsItIsTold) {
  const auto paused = post(PauseWorld{});
  loop_.start();
  EXPECT_EQ(errorOf(paused), "");
  const SimTime before = loop_.state().get()->time;
  EXPECT_EQ(errorOf(post(StepWorld{13})), "");
  EXPECT_EQ(loop_.state().get()->time, before + 26ms);
  EXPECT_TRUE(loop_.state().get()->paused);
}

TEST_F(RobotLoopTest, SaysThatItIsPausedFromItsVeryBeginning) {
  loop_.beginPaused();
  loop_.start();
  EXPECT_TRUE(loop_.state().get()->paused);
  EXPECT_EQ(loop_.state().get()->speed, 1e6);
}

TEST_F(RobotLoopTest, APauseCutsStepsShort) {
  post(PauseWorld{});
  loop_.start();
  const auto endless = post(StepWorld{INT64_MAX});
  EXPECT_EQ(errorOf(post(PauseWorld{})), "");
  EXPECT_NE(errorOf(endless), "");
}

TEST_F(RobotLoopTest, StepsOnlyAPausedWorld) {
  loop_.start();
  EXPECT_NE(errorOf(post(StepWorld{1})), "");
}

TEST_F(RobotLoopTest, SaysWhatIsNotThere) {
  loop_.start();
  EXPECT_NE(errorOf(post(runtime::WorldRequest(runtime::PlaceRobot{7, {}}))), "");
  EXPECT_EQ(errorOf(post(runtime::WorldRequest(runtime::ResetWorld{}))), "");
}

TEST_F(RobotLoopTest, FinishesWhereTimeHasToWait) {
  loop_.lockTo([](SimTime now) { return now >= SimTime(200ms); });
  loop_.start();
  std::promise<void> ended;
  loop_.finish([&] { ended.set_value(); });
  ended.get_future().wait();
  loop_.stop();
  EXPECT_EQ(loop_.state().get()->time, SimTime(200ms));
  EXPECT_NE(loop_.state().get()->hash, 0u);
}

TEST_F(RobotLoopTest, FinishesAPausedWorldWhereItIs) {
  loop_.beginPaused();
  loop_.start();
  std::promise<void> ended;
  loop_.finish([&] { ended.set_value(); });
  ended.get_future().wait();
  loop_.stop();
  EXPECT_EQ(loop_.state().get()->time, SimTime());
}

TEST_F(RobotLoopTest, TellsTheStateOnlyWhileTimeStands) {
  loop_.start();
  EXPECT_EQ(errorOf(post(PauseWorld{})), "");
  const std::uint64_t hash = loop_.state().get()->hash;
  EXPECT_NE(hash, 0u);
  EXPECT_EQ(errorOf(post(StepWorld{1})), "");
  EXPECT_NE(loop_.state().get()->hash, hash);
}

TEST_F(RobotLoopTest, GoesBackToASnapshotOfAName) {
  using runtime::WorldRequest;
  const auto paused = post(PauseWorld{});
  loop_.start();
  EXPECT_EQ(errorOf(paused), "");
  EXPECT_EQ(errorOf(post(WorldRequest(runtime::TakeSnapshot{"a"}))), "");
  const LoopState then = *loop_.state().get();
  EXPECT_EQ(then.snapshots, std::vector<std::string>{"a"});
  EXPECT_EQ(errorOf(post(StepWorld{50})), "");
  EXPECT_EQ(errorOf(post(WorldRequest(runtime::RestoreSnapshot{"b"}))), "there is no snapshot 'b'");
  const auto endless = post(StepWorld{INT64_MAX});
  EXPECT_EQ(errorOf(post(WorldRequest(runtime::RestoreSnapshot{"a"}))), "");
  EXPECT_EQ(errorOf(endless), motion::kSetBackReason);
  EXPECT_EQ(loop_.state().get()->time, then.time);
  EXPECT_EQ(loop_.state().get()->hash, then.hash);
}

// In real time this takes the third of a second that it simulates.
TEST(RobotLoop, TheStateDoesNotDependOnThePace) {
  const auto sim = [] {
    auto simulation = std::make_unique<runtime::Simulation>(
        test::flatWorld(), std::vector<sim::RobotSetup>{{"nao", test::robot("nao_h21_v33"), {}}},
        2ms);
    EXPECT_TRUE(simulation->robot(0).ports()->requests.post({1, motion::WakeUp{}}));
    return simulation;
  };
  for (const double speed : {1.0, 1e6, std::numeric_limits<double>::infinity()}) {
    const auto paced = sim();
    RobotLoop loop(*paced, speed, [] {});
    loop.start();
    while (loop.state().get()->time < SimTime(333ms)) std::this_thread::yield();
    loop.stop();
    const LoopState end = *loop.state().get();
    const auto sliced = sim();
    while (sliced->now() < end.time) sliced->advanceTo(std::min(sliced->now() + 7ms, end.time));
    EXPECT_EQ(sliced->hash(), end.hash) << "at speed " << speed;
  }
}

TEST_F(RobotLoopTest, ABeatIsMetAtItsTimeBesideTheOthers) {
  std::vector<SimTime> asked;
  std::atomic<bool> waits{false};
  loop_.keepBeat(12ms);
  loop_.lockTo([&](SimTime now) {
    asked.push_back(now);
    if (now == SimTime(36ms)) waits = true;
    return now == SimTime(36ms);
  });
  loop_.start();
  while (!waits) std::this_thread::yield();  // a pause before it asks would be met without asking
  EXPECT_EQ(errorOf(post(PauseWorld{})), "");
  loop_.stop();
  asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
  EXPECT_EQ(asked, (std::vector<SimTime>{SimTime(0ms), SimTime(10ms), SimTime(12ms), SimTime(20ms),
                                         SimTime(24ms), SimTime(30ms), SimTime(36ms)}));
}

}  // namespace
}  // namespace nao::daemon
