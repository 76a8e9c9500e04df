#include "core/leds.h"

#include <gtest/gtest.h>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

class LedsTest : public testing::Test {
 protected:
  motion::RobotPorts& ports() { return *simulation_.robot(0).ports(); }
  void runOneCycle() { simulation_.advanceTo(simulation_.now() + 10ms); }
  LedState shown() { return simulation_.truth().get()->robots[0].leds; }
  LedState reported() { return ports().sensors.get()->leds; }
  std::size_t led(const char* name) { return findLeds(names_, name).at(0); }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h25_v50");
  std::vector<std::string> names_ = ledNames(*model_);
  Simulation simulation_{test::flatWorld(), {{"nao", model_, {}}}, 2ms};
};

TEST_F(LedsTest, AreDarkAtTheStart) {
  runOneCycle();
  EXPECT_EQ(shown(), LedState{});
  EXPECT_EQ(reported(), LedState{});
}

TEST_F(LedsTest, ShowWhatTheyWereToldFromTheNextCycleOn) {
  ASSERT_TRUE(ports().leds.post({"ChestBoard/Led/Red", 0.25F}));
  ASSERT_TRUE(ports().leds.post({"LeftFootLeds", 2}));
  ASSERT_TRUE(ports().leds.post({"Tail", 1}));  // has none: ignored
  runOneCycle();
  runOneCycle();
  LedState expected{};
  expected[led("ChestBoard/Led/Red")] = 0.25F;
  for (const std::size_t i : findLeds(names_, "LFoot/Led")) expected[i] = 1;
  EXPECT_EQ(shown(), expected);
  EXPECT_EQ(reported(), expected);
}

TEST_F(LedsTest, AreStateThatASnapshotBringsBack) {
  ASSERT_TRUE(ports().leds.post({"EarLeds", 1}));
  runOneCycle();
  const auto lit = shown();
  const auto hash = simulation_.hash();
  const auto snapshot = simulation_.snapshot();
  ASSERT_TRUE(ports().leds.post({"EarLeds", 0}));
  runOneCycle();
  EXPECT_EQ(shown(), LedState{});
  simulation_.restore(*snapshot);
  EXPECT_EQ(shown(), lit);
  EXPECT_EQ(simulation_.hash(), hash);
  simulation_.apply(PlaceRobot{0, {}});
  EXPECT_EQ(shown(), LedState{});  // as after switching it on
}

}  // namespace
}  // namespace nao::runtime
