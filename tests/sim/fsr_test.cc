#include "sim/fsr.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kRounding = 1e-9;

// One force under the left foot of a robot that stands with its ankles level.
FootForces feel(const RobotModel& model, const Vec3& p_B, const Vec3& f_W) {
  const std::vector<BodyMotion> motion(model.bodies.size());
  return calcFootForces(model, motion, {{model.feet[0].body, 0, p_B, f_W, 0}})[0];
}

TEST(FootForceSensors, AForceBetweenThemIsFeltWhereItIs) {
  const auto model = test::robot("nao_h21_v33");
  Random random(4);
  for (int k = 0; k < 50; ++k) {
    const Vec3 p(random.uniform(-0.029, 0.069), random.uniform(-0.018, 0.029), -0.045);
    const double force = random.uniform(1, 20);
    const FootForces foot = feel(*model, p, Vec3(0.3, -0.2, force));
    EXPECT_NEAR(foot.total, force, kRounding);
    // The rear pair is not quite square: 0.6 mm of x and 4 mm of y between left and right.
    EXPECT_NEAR(foot.cop_x, p.x(), 0.6e-3);
    EXPECT_NEAR(foot.cop_y, p.y(), kRounding);
  }
}

TEST(FootForceSensors, ASensorFeelsWhatStandsOnItAlone) {
  const auto model = test::robot("nao_h25_v50");
  for (std::size_t i = 0; i < 4; ++i) {
    const FootForces foot = feel(*model, model->feet[0].fsr[i], Vec3(0, 0, 10));
    for (std::size_t other = 0; other < 4; ++other) {
      // 0.6 mm of the pad's 100 mm are the other end's, see above.
      EXPECT_NEAR(foot.force[other], other == i ? 10 : 0, 10 * 0.006 + kRounding);
    }
  }
}

TEST(FootForceSensors, EndAt25NewtonEach) {  // NAOqi 2.1.4.13 documentation, fsr_robot
  const auto model = test::robot("nao_h25_v50");
  const FootForces foot = feel(*model, model->feet[0].fsr[0], Vec3(0, 0, 60));
  EXPECT_EQ(foot.force[0], 25);
  EXPECT_LT(foot.total, 26);
}

class StandingOnSensors : public testing::TestWithParam<const char*> {
 protected:
  StandingOnSensors()
      : model_(test::robot(GetParam())),
        world_(test::flatWorld(), {{"nao", model_, {}}}, 2ms),
        command_{model_->findPosture("Stand")->angle, JointArray<double>(model_->jointCount(), 1)} {
    world_.placeRobot(0, {}, &command_.angle);
  }

  SensorFrame hold(Duration duration, const Vec3& push_W = Vec3::Zero()) {
    for (const SimTime end = world_.now() + duration; world_.now() < end;) {
      world_.setCommand(0, command_);
      world_.push(0, push_W, model_->cycle);
      for (Duration t{}; t < model_->cycle; t += world_.stepSize()) world_.step();
      last_ = world_.readSensors(0);
    }
    return last_;
  }
  double weight() const { return model_->totalMass() * 9.80665; }

  std::shared_ptr<const RobotModel> model_;
  World world_;
  JointCommand command_;
  SensorFrame last_;
};

TEST_P(StandingOnSensors, TheirSumIsItsWeight) {
  const SensorFrame frame = hold(2000ms);
  double sum = 0;
  for (const FootForces& foot : frame.feet) {
    for (const double force : foot.force) sum += force;
    EXPECT_NEAR(foot.total, weight() / 2, 0.1 * weight());
  }
  EXPECT_NEAR(sum, weight(), 0.01 * weight());
}

TEST_P(StandingOnSensors, TheCentreOfPressureIsInTheSole) {
  const SensorFrame frame = hold(2000ms);
  for (std::size_t i = 0; i < 2; ++i) {
    Eigen::AlignedBox2d sole;
    const FootModel& foot = model_->feet[i];
    for (const auto& p : foot.outline) {
      sole.extend(Eigen::Vector2d((foot.X_BS * Vec3(p.x(), p.y(), 0)).head<2>()));
    }
    EXPECT_TRUE(sole.contains(Eigen::Vector2d(frame.feet[i].cop_x, frame.feet[i].cop_y)));
  }
}

// From a push back to one forwards the centre of pressure of both feet moves by 2 F h / W at least:
// the play of the gears lets the robot lean on with the push.
TEST_P(StandingOnSensors, APushMovesTheCentreOfPressureAlong) {
  const double force = 2;  // [N] more and play lets it fall over its heels
  hold(1500ms);
  const double height = world_.scene().robots[0].X_WB[0].translation().z();
  double cop[2] = {};
  for (const int forwards : {0, 1}) {
    const SensorFrame frame = hold(2000ms, Vec3(forwards ? force : -force, 0, 0));
    for (const FootForces& foot : frame.feet) cop[forwards] += foot.total * foot.cop_x / weight();
  }
  EXPECT_GT(cop[1] - cop[0], 2 * force * height / weight());
  EXPECT_LT(cop[1] - cop[0], 0.1);  // the sensors' rectangle
}

// The moment F h of a push to the left is borne by 2 F h / b more on the left foot than on the
// right, for feet b apart, if the pressure under each stays where it is. It moves along, so that
// part of that is left: half at least, as a sole is no wider than the gap from foot to foot.
TEST_P(StandingOnSensors, APushLoadsTheFootItGoesTo) {
  const SensorFrame before = hold(1500ms);
  const auto X_WB = world_.scene().robots[0].X_WB;
  const auto foot = [&](std::size_t i) {
    return X_WB[static_cast<std::size_t>(model_->feet[i].body)].translation().y();
  };
  const double moment = 4 * X_WB[0].translation().z();
  const SensorFrame left = hold(1500ms, Vec3(0, 4, 0));
  const double more = 2 * moment / (foot(0) - foot(1));
  const double moved =
      left.feet[0].total - left.feet[1].total - (before.feet[0].total - before.feet[1].total);
  EXPECT_GT(moved, 0.5 * more);
  EXPECT_LT(moved, more);
  EXPECT_NEAR(left.feet[0].total + left.feet[1].total, weight(), 0.01 * weight());
}

INSTANTIATE_TEST_SUITE_P(EveryNao, StandingOnSensors,
                         testing::Values("nao_h21_v33", "nao_h25_v33", "nao_h25_v40", "nao_h25_v50",
                                         "nao_h25_v60"));

}  // namespace
}  // namespace nao::sim
