#include "validation/suspended.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/models.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

RecordedMotion swing(const std::shared_ptr<const RobotModel>& model,
                     const std::vector<std::string>& moving) {
  RecordedMotion motion{"swing", Split::Fit, 0.5, {}};
  motion.angles = [model, moving](double t) {
    JointArray<double> angle(model->jointCount());
    for (std::size_t i = 0; i < moving.size(); ++i) {
      const auto phase = static_cast<double>(i);
      angle[*model->findJoint(moving[i])] = 0.2 * (1 - std::cos((6 + phase) * t));
    }
    return angle;
  };
  return motion;
}

LogSet recordSwing(const RobotModel& robot, const std::vector<std::string>& moving) {
  RecordingPlan plan;
  plan.model = std::make_shared<RobotModel>(robot);
  plan.motions = {swing(plan.model, moving)};
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  plan.joints = {"LHipPitch", "LKneePitch", "LShoulderRoll"};
  return recordSimulated(plan);
}

TEST(Suspended, TouchesNothingAndStaysWhereItHangs) {
  RecordingPlan plan;
  plan.model = std::make_shared<RobotModel>(suspend(*nao::test::robot("nao_h21_v33")));
  plan.motions = {swing(plan.model, {"LHipPitch", "RHipPitch"})};
  plan.repeats = 1;
  plan.inertial_unit = true;
  const LogSet set = recordSimulated(plan);
  EXPECT_TRUE(set.environment.suspended);
  for (const double a : *set.runs[0].find("imu.acc.z")) EXPECT_NEAR(a, -9.80665, 1e-9);
  for (const double a : *set.runs[0].find("imu.ang.y")) EXPECT_NEAR(a, 0, 1e-9);
}

TEST(Suspended, WithoutItsSkinItMovesTheSame) {
  const RobotModel whole = suspend(*nao::test::robot("nao_h21_v33"));
  const LogSet a = recordSwing(whole, {"LHipPitch", "LKneePitch", "LShoulderPitch"});
  const LogSet b = recordSwing(stripped(whole), {"LHipPitch", "LKneePitch", "LShoulderPitch"});
  EXPECT_EQ(a.runs[0].columns, b.runs[0].columns);
}

TEST(Suspended, ALimbAloneMovesAsOnTheWholeRobot) {
  const RobotModel whole = stripped(suspend(*nao::test::robot("nao_h21_v33")));
  const std::vector<std::string> legs{"LHipPitch", "LKneePitch", "LHipYawPitch", "RHipPitch"};
  const RobotModel cut = cutLimbs(whole, {"LKneePitch"});
  EXPECT_EQ(cut.jointCount(), 11u);  // both legs, by their common motor
  const LogSet a = recordSwing(whole, legs);
  const LogSet b = recordSwing(cut, legs);
  EXPECT_EQ(b.joints.size(), 2u);
  for (const char* column : {"q.LKneePitch", "q.LHipPitch", "cur.LKneePitch"}) {
    const Column& p = *a.runs[0].find(column);
    const Column& q = *b.runs[0].find(column);
    for (std::size_t k = 0; k < p.size(); ++k) ASSERT_NEAR(p[k], q[k], 1e-12) << column << k;
  }
  const RobotModel arm = cutLimbs(whole, {"LElbowRoll"});
  EXPECT_EQ(arm.jointCount(), 4u);
  EXPECT_THROW(cutLimbs(whole, {"Tail"}), InputError);
  EXPECT_THROW(cutLimbs(*nao::test::robot("nao_h21_v33"), {"LKneePitch"}), InputError);
}

TEST(Suspended, RepeatsDifferBySeedAndNothingElse) {
  RecordingPlan plan;
  const auto model = nao::test::robot("nao_h21_v33");
  plan.model = std::make_shared<RobotModel>(cutLimbs(suspend(*model), {"HeadYaw"}));
  plan.motions = {swing(plan.model, {"HeadYaw"})};
  plan.repeats = 2;
  plan.extra = {{"process_noise", {{"sd", 0.05}}, {}, ""}};
  plan.start_sd = 0.001;
  const LogSet a = recordSimulated(plan);
  EXPECT_EQ(a.runs[0].columns.at("cmd.HeadYaw"), a.runs[1].columns.at("cmd.HeadYaw"));
  EXPECT_NE(a.runs[0].columns.at("q.HeadYaw"), a.runs[1].columns.at("q.HeadYaw"));
  EXPECT_EQ(a.runs[0].columns, recordSimulated(plan).runs[0].columns);
  plan.seed = 2;
  EXPECT_NE(a.runs[0].columns, recordSimulated(plan).runs[0].columns);
}

}  // namespace
}  // namespace nao::validation
