#include "walk_engine/stance.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/models.h"
#include "walk_engine/swing.h"

namespace nao::walk {
namespace {

constexpr double kFixedPoint = 1e-6;  // [m] what the fixed-point steps leave

class StanceTest : public testing::TestWithParam<const char*> {
 protected:
  std::shared_ptr<const RobotModel> model_ = test::robot(GetParam());
  StanceSolver stance_{model_};
  JointArray<double> angle_ = model_->findPosture("StandInit")->angle;
};

TEST_P(StanceTest, PutsSolesAndCentreOfMassWhereAsked) {
  Random random(5);
  const double height = stance_.calcComHeight(0.1, 0, angle_);
  motion::Kinematics check(model_);
  for (int i = 0; i < 200; ++i) {
    StanceDemand demand;
    demand.com = Vec3(random.uniform(-0.02, 0.02), random.uniform(-0.03, 0.03), height);
    demand.pitch = random.uniform(-0.1, 0.1);
    demand.X_OS[0] = onFloor({random.uniform(-0.03, 0.03), 0.05, random.uniform(0, 0.15)});
    demand.X_OS[1] = onFloor({random.uniform(-0.03, 0.03), -0.05, random.uniform(-0.15, 0)});
    for (int settle = 0; settle < 3; ++settle) ASSERT_TRUE(stance_.solve(demand, angle_));
    check.update(angle_);
    const Pose X_OT = demand.X_OS[0] * check.calcSole(Foot::Left).inverse();
    ASSERT_NEAR((X_OT * check.calcCom() - demand.com).norm(), 0, kFixedPoint);
    const Pose right = X_OT * check.calcSole(Foot::Right);
    ASSERT_NEAR((right.translation() - demand.X_OS[1].translation()).norm(), 0, kFixedPoint);
    ASSERT_NEAR((right.linear() - demand.X_OS[1].linear()).norm(), 0, 1e-9);
  }
}

TEST_P(StanceTest, LeavesArmsAndHeadAlone) {
  const JointArray<double> before = angle_;
  StanceDemand demand;
  demand.X_OS = {onFloor({0, 0.05, 0}), onFloor({0, -0.05, 0})};
  demand.com = Vec3(0, 0, stance_.calcComHeight(0.1, 0, angle_));
  stance_.solve(demand, angle_);
  for (const char* name : {"HeadYaw", "LShoulderPitch", "RElbowRoll"}) {
    EXPECT_EQ(angle_[*model_->findJoint(name)], before[*model_->findJoint(name)]);
  }
}

TEST_P(StanceTest, SaysWhenALegIsTooShort) {
  StanceDemand demand;
  demand.X_OS = {onFloor({0, 0.05, 0}), onFloor({0, -0.05, 0})};
  demand.com = Vec3(0, 0, 0.5);
  EXPECT_FALSE(stance_.solve(demand, angle_));
}

INSTANTIATE_TEST_SUITE_P(Robots, StanceTest, testing::Values("nao_h21_v33", "nao_h25_v50"));

}  // namespace
}  // namespace nao::walk
