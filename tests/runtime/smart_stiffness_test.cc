#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "runtime/simulation.h"
#include "tests/support/models.h"

namespace nao::runtime {
namespace {

using std::chrono_literals::operator""ms;

struct Standing {
  double stiffness = 0;  // mean of the joints' commands at the end
  double current = 0;    // [A] of all joints, mean over the last second
  double worst = 0;      // [rad] of command less sensor over all joints, in the last second
  double height = 0;     // [m] of the torso at the end
};

class SmartStiffnessTest : public testing::Test {
 protected:
  void post(motion::MotionAction action) {
    ASSERT_TRUE(simulation.robot(0).ports()->requests.post({++last_id, std::move(action)}));
  }
  void wait(Duration time) { simulation.advanceTo(simulation.now() + time); }
  double meanStiffness() const {
    const auto& sent = ports->state.get()->command.stiffness;
    return std::accumulate(sent.begin(), sent.end(), 0.0) / static_cast<double>(sent.size());
  }

  Standing stand(bool smart) {
    post(motion::SetSmartStiffness{smart});
    post(motion::WakeUp{});
    wait(7000ms);
    Standing seen;
    for (int i = 0; i < 100; ++i) {
      wait(10ms);
      const auto frame = ports->sensors.get();
      const auto state = ports->state.get();
      for (std::size_t j = 0; j < frame->angle.size(); ++j) {
        seen.current += std::abs(frame->current[j]) / 100;
        seen.worst = std::max(seen.worst, std::abs(state->command.angle[j] - frame->angle[j]));
      }
    }
    seen.stiffness = meanStiffness();
    seen.height = simulation.truth().get()->robots[0].X_WB[0].translation().z();
    return seen;
  }

  Simulation simulation{test::flatWorld(), {{"nao", test::robot("nao_h21_v33"), {}}}, 2ms};
  std::shared_ptr<motion::RobotPorts> ports = simulation.robot(0).ports();
  motion::RequestId last_id = 0;
};

TEST_F(SmartStiffnessTest, ARobotThatStandsIsSofterAndStandsAsHigh) {
  const Standing stiff = stand(false);
  EXPECT_DOUBLE_EQ(stiff.stiffness, 1);
  const Standing smart = stand(true);
  EXPECT_LT(smart.stiffness, 0.6);
  EXPECT_LE(smart.current, 1.02 * stiff.current);
  EXPECT_LT(smart.worst, stiff.worst + 0.03);
  EXPECT_NEAR(smart.height, stiff.height, 0.003);
}

TEST_F(SmartStiffnessTest, AnyMotionBringsBackWhatWasAskedFor) {
  stand(true);
  EXPECT_LT(meanStiffness(), 0.6);
  const Joint yaw = *simulation.robot(0).model().findJoint("HeadYaw");
  post(motion::SetAngles{{yaw}, {0.5}, {0.1}});
  wait(100ms);
  EXPECT_DOUBLE_EQ(meanStiffness(), 1);
}

TEST_F(SmartStiffnessTest, WhatWasAskedForIsTheMost) {
  stand(true);
  const Joint yaw = *simulation.robot(0).model().findJoint("HeadYaw");
  post(motion::SetStiffness{{yaw}, {0.05}});
  wait(4000ms);
  EXPECT_DOUBLE_EQ(ports->state.get()->command.stiffness[yaw], 0.05);
  EXPECT_DOUBLE_EQ(ports->state.get()->stiffness[yaw], 0.05);
  EXPECT_LT(meanStiffness(), 0.6);
}

}  // namespace
}  // namespace nao::runtime
