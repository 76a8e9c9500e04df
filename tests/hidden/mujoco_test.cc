#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "tests/hidden/hideout.h"
#include "tests/hidden/mujoco/recording.h"
#include "tests/support/models.h"
#include "validation/suspended.h"

namespace nao::hidden {
namespace {

using validation::RecordingPlan;

// Half a second of rest and 1.5 s of a tone that comes near the joint's speed, without noise.
RecordingPlan toneOf(const std::string& joint, double middle) {
  const RobotModel hung = suspend(*test::robot("nao_h21_v33"));
  const auto limb =
      std::make_shared<RobotModel>(validation::cutLimbs(validation::stripped(hung), {joint}));
  const Joint moving = *limb->findJoint(joint);
  const JointArray<double> rest = limb->findPosture(limb->start_posture)->angle;
  RecordingPlan plan;
  plan.model = limb;
  plan.joints = {joint};
  plan.repeats = 1;
  plan.current = false;
  const auto angles = [=](double t) {
    JointArray<double> angle = rest;
    angle[moving] = middle + 0.3 * std::sin(2 * M_PI * 1.2 * t);
    return angle;
  };
  plan.motions = {{"tone", validation::Split::Fit, 1.5, angles}};
  return plan;
}

std::vector<double> anglesOf(const validation::LogSet& set) {
  return set.runs.front().columns.at("q." + set.joints.front().name);
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(squares / static_cast<double>(a.size()));
}

class MujocoReality : public testing::Test {
  void SetUp() override {
    if (!hasMujoco()) GTEST_SKIP() << "MuJoCo is not installed (libmujoco-dev)";
  }
};

// Encoders count 1.5 mrad: two that round alike motions differ by an RMS of 0.6 mrad. MuJoCo's
// step answers 0.15 ms sooner than ours, which at 3 rad/s is 0.5 mrad more.
TEST_F(MujocoReality, MovesTheNominalRobotAsOurWorldDoesToAnEncodersCount) {
  for (const auto& [joint, middle] :
       std::vector<std::pair<std::string, double>>{{"HeadYaw", 0.2}, {"LShoulderPitch", 1}}) {
    const RecordingPlan plan = toneOf(joint, middle);
    const auto ours = anglesOf(validation::recordSimulated(plan));
    EXPECT_LT(rms(anglesOf(recordMujoco(plan)), ours), 1.2e-3) << joint;
  }
}

TEST_F(MujocoReality, EveryHideoutShows) {
  RecordingPlan plan = toneOf("LShoulderPitch", 1.75);
  const auto without = anglesOf(recordMujoco(plan));
  for (const Hideout& hideout : mujocoHideouts()) {
    plan.extra = {settingAt(hideout, hideout.most / 2, *plan.model, "LShoulderPitch")};
    // The lower stop is far from this tone.
    if (hideout.parameter == "lower") plan.extra[0].parameters["lower"] = 4;
    // Nothing else differs, not even chance.
    EXPECT_GT(rms(anglesOf(recordMujoco(plan)), without), 3e-4) << hideout.law;
  }
}

// Sizes are looked for far beyond what a joint can have: one that ended the program ended a bench.
TEST_F(MujocoReality, StopsBeyondEachOtherHoldTheJoint) {
  RecordingPlan plan = toneOf("HeadYaw", 0);
  plan.extra = {{"mujoco_range", {{"upper", -10}}, {*plan.model->findJoint("HeadYaw")}, ""}};
  const auto angles = anglesOf(recordMujoco(plan));
  const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
  EXPECT_LT(*most - *least, 0.3);  // of 0.6
}

TEST_F(MujocoReality, KnowsNoOtherLaws) {
  RecordingPlan plan = toneOf("HeadYaw", 0);
  plan.extra = {{"coulomb_friction", {{"torque", 0.1}}, {}, ""}};
  EXPECT_THROW(recordMujoco(plan), InputError);
}

}  // namespace
}  // namespace nao::hidden
