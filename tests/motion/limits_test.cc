#include "motion/limits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/motion_engine.h"
#include "tests/support/models.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kRounding = 1e-12;  // [rad] of one linear interpolation

class CoupledLimits : public testing::Test {
 protected:
  /// What becomes of a command of these two joints alone, by the motion engine of a stiff robot.
  double commanded(const char* driver, double driver_angle, const char* limited, double angle) {
    MotionEngine engine(model_, nullptr);
    SensorFrame frame;
    frame.angle = model_->findPosture("StandInit")->angle;
    SetStiffness stiff;
    for (std::size_t i = 0; i < model_->jointCount(); ++i) {
      stiff.joints.push_back(toJoint(i));
      stiff.stiffness.push_back(1);
    }
    engine.update(frame);
    engine.accept({1, stiff});
    const Joint a = *model_->findJoint(driver);
    const Joint b = *model_->findJoint(limited);
    engine.accept({2, SetAngles{{a, b}, {driver_angle, angle}, {1, 1}, false}});
    JointCommand command;
    for (int k = 0; k < 100; ++k) command = engine.update(frame);  // 1 s: longer than any way
    EXPECT_NEAR(command.angle[a], driver_angle, kRounding);
    return command.angle[b];
  }

  std::shared_ptr<RobotModel> model_ = std::make_shared<RobotModel>(*test::robot("nao_h21_v33"));
};

// Right ankle by the published table: at -1.189442 rad of pitch [-0.075049, 0.049916], at -0.840027
// rad [-0.169995, 0.179943], straight between.
TEST_F(CoupledLimits, ARollAtABentAnkleEndsAtThePublishedTable) {
  const double pitch = -60 * kDegree;
  const double part = (pitch + 1.189442) / (1.189442 - 0.840027);
  const double most = 0.049916 + part * (0.179943 - 0.049916);
  const double least = -0.075049 + part * (-0.169995 + 0.075049);
  ASSERT_LT(most, 10 * kDegree);
  EXPECT_NEAR(commanded("RAnklePitch", pitch, "RAnkleRoll", 10 * kDegree), most, kRounding);
  EXPECT_NEAR(commanded("RAnklePitch", pitch, "RAnkleRoll", -10 * kDegree), least, kRounding);
  EXPECT_NEAR(commanded("LAnklePitch", pitch, "LAnkleRoll", -10 * kDegree), -most, kRounding);
  EXPECT_NEAR(commanded("RAnklePitch", pitch, "RAnkleRoll", 3 * kDegree), 3 * kDegree, kRounding);
}

TEST_F(CoupledLimits, AHeadTurnedAsideNodsLess) {
  // A row of the table, and half way between two.
  EXPECT_NEAR(commanded("HeadYaw", 1.089958, "HeadPitch", 0.5), 0.300022, kRounding);
  EXPECT_NEAR(commanded("HeadYaw", -1.089958, "HeadPitch", -0.6), -0.430049, kRounding);
  EXPECT_NEAR(commanded("HeadYaw", 0.486074 / 2, "HeadPitch", 0.5), (0.515047 + 0.422021) / 2,
              kRounding);
}

TEST_F(CoupledLimits, EachCanBeSwitchedOff) {
  for (CoupledLimit& limit : model_->coupled_limits) {
    if (model_->actuators[index(limit.limited)].name == "RAnkleRoll") limit.clip = false;
  }
  const double pitch = -60 * kDegree;
  EXPECT_NEAR(commanded("RAnklePitch", pitch, "RAnkleRoll", 0.3), 0.3, kRounding);
  EXPECT_LT(std::abs(commanded("LAnklePitch", pitch, "LAnkleRoll", -0.3)), 0.11);
}

}  // namespace
}  // namespace nao::motion
