// Two runs share their hash only if they went alike.
#include "runtime/run_hash.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

using Acts = std::function<void(Simulation&, motion::RobotPorts&)>;

/// The hash of a second of a robot that wakes up, and has `acts` done to it after 300 ms.
std::uint64_t hashOf(const Acts& acts, Duration slice = 10ms, motion::RequestId first = 1) {
  Simulation simulation(test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms);
  RunHash hash;
  simulation.watch(hash);
  motion::RobotPorts& ports = *simulation.robot(0).ports();
  EXPECT_TRUE(ports.requests.post({first, motion::WakeUp{}}));
  simulation.advanceTo(SimTime(300ms));
  acts(simulation, ports);
  for (SimTime t(300ms); t < SimTime(1000ms); t += slice) simulation.advanceTo(t);
  simulation.advanceTo(SimTime(1000ms));
  return hash.value();
}

void nothing(Simulation&, motion::RobotPorts&) {}

Acts post(const motion::MotionAction& action, motion::RequestId id = 2) {
  return [=](Simulation&, motion::RobotPorts& ports) {
    EXPECT_TRUE(ports.requests.post({id, action}));
  };
}

TEST(RunHash, IsTheSameForTheSameInputsHoweverTheyAreNumberedAndTimeIsSliced) {
  const std::uint64_t quiet = hashOf(nothing);
  EXPECT_EQ(hashOf(nothing, 14ms), quiet);
  EXPECT_EQ(hashOf(nothing, 10ms, 77), quiet);
  const auto walk = motion::MoveToward{1, 0, 0, {}};
  EXPECT_EQ(hashOf(post(walk, 2)), hashOf(post(walk, 99), 6ms));
}

TEST(RunHash, ShowsEveryInput) {
  const std::vector<Acts> all = {
      nothing,
      post(motion::MoveToward{1, 0, 0, {}}),
      post(motion::MoveToward{1, 0, 0.1, {}}),
      post(motion::Kill{77}),  // nothing comes of it
      [](Simulation&, motion::RobotPorts& ports) {
        EXPECT_TRUE(ports.leds.post({"ChestLeds", 1.0f}));
      },
      [](Simulation&, motion::RobotPorts& ports) {
        EXPECT_TRUE(ports.leds.post({"no such light", 1.0f}));
      },
      [](Simulation& simulation, motion::RobotPorts& ports) {
        const JointArray<double> zeros(simulation.robot(0).model().jointCount());
        ports.body.publish(BodyCommand{1, zeros, zeros});
      },
      [](Simulation& simulation, motion::RobotPorts&) {
        simulation.apply(PushRobot{0, Vec3(1, 0, 0), 10ms});
      },
      [](Simulation& simulation, motion::RobotPorts&) { simulation.apply(TakeSnapshot{"a"}); },
      [](Simulation& simulation, motion::RobotPorts&) { simulation.apply(TakeSnapshot{"b"}); }};
  std::set<std::uint64_t> hashes;
  for (const Acts& acts : all) hashes.insert(hashOf(acts));
  EXPECT_EQ(hashes.size(), all.size());
}

TEST(RunHash, ShowsWhenAnInputCame) {
  const auto pushed = [](SimTime time) {
    return hashOf([time](Simulation& simulation, motion::RobotPorts&) {
      simulation.advanceTo(time);
      simulation.apply(TakeSnapshot{"a"});
    });
  };
  EXPECT_EQ(pushed(SimTime(302ms)), pushed(SimTime(302ms)));
  EXPECT_NE(pushed(SimTime(302ms)), pushed(SimTime(304ms)));
}

TEST(RunHash, DoesNotChangeTheRun) {
  const auto stateAfter = [](bool watched) {
    Simulation simulation(test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms);
    RunHash hash;
    if (watched) simulation.watch(hash);
    EXPECT_TRUE(simulation.robot(0).ports()->requests.post({1, motion::WakeUp{}}));
    simulation.advanceTo(SimTime(500ms));
    return simulation.hash();
  };
  EXPECT_EQ(stateAfter(true), stateAfter(false));
}

}  // namespace
}  // namespace nao::runtime
