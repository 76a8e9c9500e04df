#include "validation/diagnosis/replay/limb_replay.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/suspend.h"
#include "tests/support/models.h"
#include "validation/diagnosis/whole/whole_data.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

// Some joints of a robot that hangs, in one motion, and both ways to replay it.
class HungRobot {
 public:
  explicit HungRobot(const std::vector<std::string>& joints)
      : model_(std::make_shared<RobotModel>(suspend(*test::robot("nao_h21_v33")))),
        whole_(record(joints), model_),
        limbs_(whole_, whole_.judged(), Pace::Exact),
        coarse_(whole_, whole_.judged(), Pace::Coarse) {}

  const RobotModel& model() const { return *model_; }
  const WholeSimulator& simulator() const { return whole_; }
  WholeRun whole(const std::vector<EffectSetting>& causes) const {
    return whole_.simulate(causes, 0, 1, 0, Pace::Coarse);
  }
  WholeRun limbs(const std::vector<EffectSetting>& causes) const {
    return limbs_.simulate(causes, 0, 1, 0);
  }
  WholeRun coarse(const std::vector<EffectSetting>& causes) const {
    return coarse_.simulate(causes, 0, 1, 0);
  }
  const WholeRun& measured() const { return whole_.measured()[0]; }
  WholeRun noisy(const std::vector<EffectSetting>& causes, std::uint64_t stream) const {
    return limbs_.simulate(causes, 0, stream, 1);
  }

 private:
  LogSet record(const std::vector<std::string>& joints) const {
    RecordingPlan plan;
    plan.model = model_;
    plan.motions = {standardRecording(model_).front()};
    moveOnly(joints, model_, plan.motions);
    plan.joints = joints;
    plan.repeats = 1;
    return recordSimulated(plan);
  }

  std::shared_ptr<const RobotModel> model_;
  WholeSimulator whole_;
  LimbReplay limbs_, coarse_;
};

// [rad] RMS over a joint's course.
double apart(const HungRobot& robot, const WholeRun& a, const WholeRun& b, const char* name) {
  const auto j = static_cast<Eigen::Index>(index(*robot.model().findJoint(name)));
  return (a.angle.col(j) - b.angle.col(j)).norm() / std::sqrt(static_cast<double>(a.angle.rows()));
}

const char* const kThigh[] = {"LHipYawPitch", "LHipRoll", "LHipPitch", "LKneePitch"};

// By steps of 1 ms as it is; an encoder's rounding is 0.44 mrad RMS.
TEST(LimbReplay, IsWhatTheWholeRobotsLimbDoesBeforeEncodersRoundIt) {
  const HungRobot robot({kThigh, kThigh + 4});
  const Joint thigh = *robot.model().findJoint("LHipPitch");
  const Joint shank = *robot.model().findJoint("LKneePitch");
  const std::vector<EffectSetting> causes{{"link_mass", {{"part", 0.5}}, {shank}, ""},
                                          {"kp_error", {{"part", -0.4}}, {thigh}, ""}};
  for (const char* name : kThigh) {
    EXPECT_LT(apart(robot, robot.whole({}), robot.coarse({}), name), 5e-4) << name;
    EXPECT_LT(apart(robot, robot.whole(causes), robot.coarse(causes), name), 5e-4) << name;
  }
  EXPECT_GT(apart(robot, robot.whole({}), robot.whole(causes), "LHipPitch"), 5e-3);
}

// A hundredth of the readings by one count of the encoder: mass matrices are of every millisecond.
TEST(LimbReplay, IsAsTheRecordedRobotByStepsAsShortAsItsOwn) {
  const HungRobot robot({kThigh, kThigh + 4});
  constexpr double kCount = 1.53e-3;  // [rad]
  for (const char* name : kThigh) {
    EXPECT_LT(apart(robot, robot.limbs({}), robot.measured(), name), 0.1 * kCount) << name;
  }
}

TEST(LimbReplay, KnowsNothingOfOtherLimbs) {
  const HungRobot robot({"HeadYaw"});
  const WholeRun head = robot.limbs({});
  const auto column = [&](const char* name) -> Eigen::VectorXd {
    return head.angle.col(static_cast<Eigen::Index>(index(*robot.model().findJoint(name))));
  };
  EXPECT_GT(column("HeadYaw").cwiseAbs().maxCoeff(), 0.1);
  EXPECT_EQ(column("LKneePitch").norm(), 0);
}

TEST(LimbReplay, AStreamDrawsTheSameWhateverTheCausesAndAnotherDoesNot) {
  const HungRobot robot({"HeadYaw", "LElbowRoll"});
  const Joint elbow = *robot.model().findJoint("LElbowRoll");
  const EffectSetting bias{"torque_bias", {{"torque", 1}}, {elbow}, ""};
  const WholeRun one = robot.noisy({}, 1);
  EXPECT_EQ(apart(robot, one, robot.noisy({bias}, 1), "HeadYaw"), 0);
  EXPECT_GT(apart(robot, one, robot.noisy({bias}, 1), "LElbowRoll"), 1e-2);
  EXPECT_GT(apart(robot, one, robot.noisy({}, 2), "HeadYaw"), 0);
}

// A budget counts in coarse runs: an exact one takes as long as three.
TEST(LimbReplay, ExactRunsCostMore) {
  const HungRobot robot({"HeadYaw"});
  const WholeData data(robot.simulator(), robot.simulator().judged(), false);
  data.simulate({}, 2, 1, Blocks::All, 1, 1, 1, Pace::Coarse);
  EXPECT_EQ(data.used(), 2);
  data.simulate({}, 2, 1, Blocks::All, 1, 1, 1, Pace::Exact);
  EXPECT_EQ(data.used(), 2 + 3 * 2);
}

}  // namespace
}  // namespace nao::validation
