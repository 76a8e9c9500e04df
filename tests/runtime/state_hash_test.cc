// Equal runs have equal hashes however they are run, and hidden differences show.
#include <gtest/gtest.h>

#include <thread>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

std::unique_ptr<Simulation> walker(std::uint64_t seed) {
  sim::WorldOptions options(2ms);
  options.seed = seed;
  auto simulation = std::make_unique<Simulation>(
      test::flatWorld(),
      std::vector<sim::RobotSetup>{{"a", test::robot("nao_h21_v33"), {}},
                                   {"b", test::robot("nao_h25_v50"), {0, -0.8, 0}}},
      options);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(simulation->robot(i).ports()->requests.post({1, motion::WakeUp{}}));
  }
  return simulation;
}

void startWalk(Simulation& simulation, const motion::GaitConfig& config = {}) {
  EXPECT_TRUE(
      simulation.robot(0).ports()->requests.post({2, motion::MoveToward{1, 0, 0.2, config}}));
}

std::uint64_t run(std::uint64_t seed, Duration slice = 10ms) {
  const auto simulation = walker(seed);
  const auto goTo = [&](SimTime end) {
    while (simulation->now() < end) {
      simulation->advanceTo(std::min(simulation->now() + slice, end));
    }
  };
  goTo(SimTime(4000ms));
  startWalk(*simulation);
  goTo(SimTime(6000ms));
  return simulation->hash();
}

TEST(StateHash, IsTheSameOnOneThreadAndOnFour) {
  constexpr std::size_t kWorlds = 4;
  std::uint64_t alone[kWorlds];
  std::uint64_t together[kWorlds];
  for (std::size_t i = 0; i < kWorlds; ++i) alone[i] = run(i);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < kWorlds; ++i) {
    threads.emplace_back([&together, i] { together[i] = run(i); });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < kWorlds; ++i) EXPECT_EQ(alone[i], together[i]) << i;
}

TEST(StateHash, IsTheSameInSlicesOfAnyLength) {
  const std::uint64_t whole = run(1, 10000ms);
  for (const Duration slice : {2ms, 3ms, 14ms, 997ms}) EXPECT_EQ(run(1, slice), whole);
}

TEST(StateHash, IsTheSameWithACameraThatLooksOn) {
  const auto blind = walker(1);
  const auto seen = walker(1);
  const auto feed = std::make_shared<camera::ImageFeed>();
  feed->subscribe({0, {160, 120}, camera::ColorSpace::kRGB, 30});
  const auto pictures = std::make_shared<camera::RenderQueue>(feed);
  seen->showTo(pictures, 0);
  camera::Renderer renderer;
  int drawn = 0;
  for (SimTime t{}; t < SimTime(1000ms); t += 10ms) {
    blind->advanceTo(t);
    seen->advanceTo(t);
    while (pictures->renderNext(renderer)) ++drawn;
  }
  EXPECT_GT(drawn, 20);
  EXPECT_EQ(seen->hash(), blind->hash());
}

// Bodies alike, minds not: what only the gait or a timeline knows is part of the state.
TEST(StateHash, ShowsWhatNoJointShowsYet) {
  const auto a = walker(0);
  a->advanceTo(SimTime(4000ms));
  const auto snapshot = a->snapshot();
  const auto b = walker(0);
  b->restore(*snapshot);
  motion::GaitConfig high;
  high.step_height = 0.023;  // takes no longer than 0.02
  startWalk(*a);
  startWalk(*b, high);
  for (const auto& simulation : {a.get(), b.get()}) simulation->advanceTo(SimTime(4012ms));
  EXPECT_EQ(a->world().hash(), b->world().hash());
  EXPECT_NE(a->hash(), b->hash());
}

TEST(StateHash, ShowsTheKeysAndTargetsAhead) {
  const auto original = walker(0);
  original->advanceTo(SimTime(4000ms));
  const auto snapshot = original->snapshot();
  const Joint head = *test::robot("nao_h21_v33")->findJoint("HeadYaw");
  const auto hashAfter = [&](const motion::MotionAction& action) {
    original->restore(*snapshot);
    EXPECT_TRUE(original->robot(0).ports()->requests.post({9, action}));
    original->acceptRequests();
    return original->hash();
  };
  const auto nod = [head](double last) {
    return motion::Interpolate{{{head, {{1, 0.2, {}, {}}, {2, last, {}, {}}}}}, false, true};
  };
  const auto ramp = [head](double last) {
    return motion::InterpolateStiffness{{{head, {last}, {2.0}}}};
  };
  using motion::SetAngles;
  EXPECT_EQ(hashAfter(nod(0.5)), hashAfter(nod(0.5)));
  EXPECT_NE(hashAfter(nod(0.5)), hashAfter(nod(0.6)));
  EXPECT_NE(hashAfter(ramp(0.5)), hashAfter(ramp(0.6)));
  EXPECT_NE(hashAfter(SetAngles{{head}, {0.5}, {0.1}, false}),
            hashAfter(SetAngles{{head}, {0.5}, {0.2}, false}));
  EXPECT_NE(hashAfter(motion::GoToPosture{"Sit", 0.5}),
            hashAfter(motion::GoToPosture{"Crouch", 0.5}));
  EXPECT_NE(hashAfter(motion::SetMoveArms{true, true}),
            hashAfter(motion::SetMoveArms{true, false}));
  EXPECT_NE(hashAfter(motion::WakeUp{}), hashAfter(motion::Rest{}));
}

}  // namespace
}  // namespace nao::runtime
