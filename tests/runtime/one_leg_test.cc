// The whole body's balance on one leg, in physics: with play, friction, delays and what a seed
// draws.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

class OneLeg : public testing::TestWithParam<motion::Feet> {
 protected:
  // The robot that a seed draws stands on both feet.
  void begin(std::uint64_t seed) {
    sim::WorldOptions options(2ms);
    options.seed = seed;
    simulation_ = std::make_unique<Simulation>(
        test::flatWorld(), std::vector<sim::RobotSetup>{{"nao", model_, {}}}, options);
    ask(motion::WakeUp{});
    wait(4s);
  }
  void ask(motion::MotionAction action) {
    ASSERT_TRUE(simulation_->robot(0).ports()->requests.post({++last_id_, std::move(action)}));
  }
  void wait(Duration time) { simulation_->advanceTo(simulation_->now() + time); }

  Pose pose(std::size_t body) { return simulation_->world().scene().robots[0].X_WB[body]; }
  double tilt() { return std::acos(pose(0).linear()(2, 2)); }
  Vec3 sole(std::size_t foot) {
    const FootModel& model = model_->feet[foot];
    return pose(static_cast<std::size_t>(model.body)) * model.X_BS.translation();
  }

  const std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  std::unique_ptr<Simulation> simulation_;
  motion::RequestId last_id_ = 0;
};

TEST_P(OneLeg, StandsForThreeSecondsWithTheOtherFootInTheAir) {
  const bool left = GetParam() == motion::Feet::Left;
  const std::size_t stance = left ? 0 : 1;
  for (const std::uint64_t seed : {1, 2, 3}) {
    begin(seed);
    ask(motion::WbEnable{true});
    ask(motion::WbFootState{motion::FootState::Fixed, motion::Feet::Both});
    ask(motion::WbBalance{true, motion::Feet::Both});
    ask(motion::WbGoToBalance{GetParam(), 2});
    wait(2500ms);
    ask(motion::WbFootState{motion::FootState::Free,
                            left ? motion::Feet::Right : motion::Feet::Left});
    ask(motion::WbBalance{true, GetParam()});
    const Vec3 stood = sole(stance);
    motion::PoseTrack lift;
    lift.chain = left ? "RLeg" : "LLeg";
    lift.space = motion::Space::Robot;
    lift.mask = 63;
    Pose up = Pose::Identity();
    up.translation() = Vec3(-0.03, 0, 0.04);
    lift.path = {up};
    lift.times = {1.5};
    ask(motion::InterpolatePoses{{lift}, true});
    wait(2s);
    double lowest = 1;
    for (int i = 0; i < 300; ++i) {
      wait(10ms);
      lowest = std::min(lowest, sole(1 - stance).z());
    }
    EXPECT_GT(lowest, 0.03) << seed;  // of the 0.04 m ordered: gear play and what joints give way
    EXPECT_LT(tilt(), 0.25) << seed;
    EXPECT_LT((sole(stance) - stood).norm(), 0.002) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Legs, OneLeg, testing::Values(motion::Feet::Left, motion::Feet::Right),
                         [](const auto& feet) {
                           return feet.param == motion::Feet::Left ? "Left" : "Right";
                         });

}  // namespace
}  // namespace nao::runtime
