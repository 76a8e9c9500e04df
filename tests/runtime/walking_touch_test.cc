// What a walking Nao's touch sensors and sonar report on an empty floor: nothing.
#include <gtest/gtest.h>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

class WalkingTouch : public testing::TestWithParam<const char*> {};

TEST_P(WalkingTouch, BumpersDoNotFireFromTheFloor) {
  const auto model = test::robot(GetParam());
  Simulation simulation(test::flatWorld(), {{"nao", model, {}}}, 2ms);
  motion::RobotPorts& ports = *simulation.robot(0).ports();
  ASSERT_TRUE(ports.requests.post({1, motion::WakeUp{}}));
  simulation.advanceTo(SimTime(5000ms));
  ASSERT_TRUE(ports.requests.post({2, motion::MoveTo{{0.3, 0, 0.5}, {}, {}}}));
  int lifted = 0;
  for (int cycle = 0; cycle < 1000; ++cycle) {
    simulation.advanceTo(simulation.now() + model->cycle);
    const auto frame = ports.sensors.get();
    for (const FootForces& foot : frame->feet) {
      EXPECT_FALSE(foot.bumper[0] || foot.bumper[1]) << cycle;
      lifted += foot.total == 0 ? 1 : 0;
    }
    const TouchState& touch = frame->touch;
    EXPECT_FALSE(touch.chest_button || touch.head[0] || touch.head[1] || touch.head[2]);
    for (const auto& hand : touch.hand) EXPECT_FALSE(hand[0] || hand[1] || hand[2]);
    for (const SonarEchoes& echoes : frame->sonar) EXPECT_EQ(echoes[0], model->sonar.max_range);
  }
  EXPECT_GT(lifted, 100);  // it did walk
}

INSTANTIATE_TEST_SUITE_P(Naos, WalkingTouch,
                         testing::Values("nao_h21_v33", "nao_h25_v40", "nao_h25_v50",
                                         "nao_h25_v60"));

}  // namespace
}  // namespace nao::runtime
