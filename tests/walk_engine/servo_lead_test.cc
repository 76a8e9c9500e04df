#include "walk_engine/servo_lead.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::walk {
namespace {

constexpr double kGravity = 9.80665;  // [m/s^2]

class ServoLeadTest : public testing::Test {
 protected:
  ServoLeadTest() { kinematics_.update(angle_); }

  // The torso's place for which the left sole is at the origin of O.
  Pose torso() const { return kinematics_.calcSole(Foot::Left).inverse(); }
  double torque(const char* joint) const { return lead_.torque()[*model_->findJoint(joint)]; }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33_ideal");  // without play
  JointArray<double> angle_ = model_->findPosture("StandInit")->angle;
  motion::Kinematics kinematics_{model_};
  ServoLead lead_{model_};
};

TEST_F(ServoLeadTest, HoldsTheWholeRobotWithTheAnkleOfTheStandingLeg) {
  lead_.plan(angle_, kinematics_, torso(), {true, false}, true);
  JointArray<double> command = angle_;
  lead_.apply(command);
  // Everything but the foot hangs on the ankle's roll axis; levers from the ankle, statics alone.
  const int foot = model_->feet[0].body;
  const Body& sole = model_->bodies[static_cast<std::size_t>(foot)];
  const Vec3 ankle = (torso() * kinematics_.getPose(foot)).translation();
  const Vec3 com = torso() * kinematics_.calcCom();
  const Vec3 foot_com = torso() * kinematics_.getPose(foot) * sole.p_BoBcm;
  const double above = model_->totalMass() * (com.y() - ankle.y()) -
                       sole.mass * (foot_com.y() - ankle.y());  // [kg m]
  // A body that leans to the right (-y) is held by pressing the foot's right edge down: the motor
  // turns the foot about +x against the leg.
  EXPECT_NEAR(torque("LAnkleRoll"), -kGravity * above, 1e-9);
  EXPECT_GT(torque("LAnkleRoll"), 1);  // [N m] about 4.9 kg at 5 cm
}

TEST_F(ServoLeadTest, IsTheSameForBothLegsWhenBothStandAlike) {
  lead_.plan(angle_, kinematics_, torso(), {true, true}, true);
  JointArray<double> command = angle_;
  lead_.apply(command);
  EXPECT_NEAR(torque("LKneePitch"), torque("RKneePitch"), 1e-9);
  EXPECT_NEAR(torque("LHipRoll"), -torque("RHipRoll"), 1e-9);
  EXPECT_LT(torque("LKneePitch"), -0.1);  // [N m] a bent knee must stretch, which is negative
}

TEST_F(ServoLeadTest, CommandsAheadByTorqueOverGain) {
  lead_.plan(angle_, kinematics_, torso(), {true, true}, true);
  JointArray<double> command = angle_;
  lead_.apply(command);
  const Joint knee = *model_->findJoint("LKneePitch");
  EXPECT_NEAR(command[knee] - angle_[knee],
              lead_.torque()[knee] / model_->actuators[index(knee)].kp, 1e-12);
}

TEST_F(ServoLeadTest, PushesFromTheEndOfThePlayThatTheFileDocuments) {
  const auto worn = test::robot("nao_h21_v33");
  ServoLead lead(worn);
  lead.plan(angle_, kinematics_, torso(), {true, true}, true);
  JointArray<double> command = angle_;
  lead.apply(command);
  const Joint knee = *worn->findJoint("LKneePitch");
  const double torque = lead.torque()[knee];  // negative: it stretches
  const double half_play = 0.7 * M_PI / 180;
  EXPECT_NEAR(command[knee] - angle_[knee], torque / worn->actuators[index(knee)].kp - half_play,
              0.01 * half_play);
}

TEST_F(ServoLeadTest, CommandsAheadOfASteadyTurnByItsLag) {
  const Joint head = *model_->findJoint("HeadYaw");
  const Joint knee = *model_->findJoint("LKneePitch");
  const Actuator& motor = model_->actuators[index(knee)];
  JointArray<double> command;
  for (int i = 0; i < 3; ++i) {  // poses that do not move, so that only the angle's rate counts
    JointArray<double> planned = angle_;
    planned[knee] += 0.01 * i;
    lead_.plan(planned, kinematics_, torso(), {true, true}, i == 0);
    command = planned;
    lead_.apply(command);
  }
  const double rate = 0.01 / 0.01;  // [rad/s]
  const double held = angle_[knee] + 0.01 + lead_.torque()[knee] / motor.kp;
  EXPECT_NEAR(command[knee] - held, rate * (motor.kd / motor.kp + 0.005), 1e-12);
  EXPECT_EQ(command[head], angle_[head]);
}

}  // namespace
}  // namespace nao::walk
