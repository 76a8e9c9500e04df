// Tactile sensors and the button feel a ball that meets the robot at their place. It comes fast
// enough to fall little on its way.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

struct Throw {
  const char* robot;
  const char* sensor;  // a frame of the robot
  Vec3 from_B;         // [m] from the sensor, in its body
  Vec3 v_B;            // [m/s]
};

void PrintTo(const Throw& one, std::ostream* out) { *out << one.robot << ' ' << one.sensor; }

class TouchedByABall : public testing::TestWithParam<Throw> {
 protected:
  TouchedByABall() : world_(withBall(), {{"nao", model_, {}}}, 2ms) {
    world_.placeRobot(0, {}, &command_.angle);
  }
  static std::shared_ptr<const WorldModel> withBall() {
    auto world = test::flatWorld();
    world->balls.push_back({});
    world->balls[0].p_W = Vec3(5, 0, 0);
    return world;
  }
  SensorFrame sense() {
    world_.setCommand(0, command_);
    for (int k = 0; k < 5; ++k) {
      world_.step();
      const SensorFrame now = world_.readSensors(0);
      head_ |= now.touch.head[0] || now.touch.head[1] || now.touch.head[2];
      for (const auto& hand : now.touch.hand) hands_ |= hand[0] || hand[1] || hand[2];
      chest_ |= now.touch.chest_button;
    }
    return world_.readSensors(0);
  }
  void throwBall() {
    const auto frame = std::find_if(model_->frames.begin(), model_->frames.end(),
                                    [](const Frame& f) { return f.name == GetParam().sensor; });
    ASSERT_NE(frame, model_->frames.end());
    const Pose X_WB = world_.scene().robots[0].X_WB[static_cast<std::size_t>(frame->body)];
    world_.placeBall(0, X_WB * (frame->X_BF.translation() + GetParam().from_B),
                     X_WB.linear() * GetParam().v_B);
  }

  std::shared_ptr<const RobotModel> model_ = test::robot(GetParam().robot);
  JointCommand command_{model_->findPosture("StandInit")->angle,
                        JointArray<double>(model_->jointCount(), 1)};
  World world_;
  bool head_ = false, hands_ = false, chest_ = false;
};

TEST_P(TouchedByABall, FeelsItThereAndNowhereElse) {
  for (int cycle = 0; cycle < 20; ++cycle) sense();
  EXPECT_FALSE(head_ || hands_ || chest_);
  throwBall();
  for (int cycle = 0; cycle < 20; ++cycle) sense();
  const std::string sensor = GetParam().sensor;
  EXPECT_EQ(head_, sensor.rfind("Head", 0) == 0);
  EXPECT_EQ(hands_, sensor.find("Hand/") != std::string::npos);
  EXPECT_EQ(chest_, sensor == "ChestBoard/Button");
}

INSTANTIATE_TEST_SUITE_P(
    Naos, TouchedByABall,
    testing::Values(Throw{"nao_h21_v33", "Head/Touch/Middle", {0, 0, 0.1}, {0, 0, -1}},
                    Throw{"nao_h25_v50", "Head/Touch/Middle", {0, 0, 0.1}, {0, 0, -1}},
                    Throw{"nao_h25_v60", "Head/Touch/Front", {0.05, 0, 0.1}, {-0.5, 0, -1}},
                    Throw{"nao_h21_v33", "ChestBoard/Button", {0.15, 0, 0}, {-2, 0, 0}},
                    Throw{"nao_h25_v50", "ChestBoard/Button", {0.15, 0, 0}, {-2, 0, 0}},
                    Throw{"nao_h25_v50", "LHand/Touch/Left", {0, 0.06, 0}, {0, -3, 0}},
                    Throw{"nao_h25_v50", "RHand/Touch/Right", {0, -0.06, 0}, {0, 3, 0}}),
    [](const auto& thrown) {
      std::string name = std::string(thrown.param.robot) + thrown.param.sensor;
      name.erase(std::remove(name.begin(), name.end(), '/'), name.end());
      return name;
    });

}  // namespace
}  // namespace nao::sim
