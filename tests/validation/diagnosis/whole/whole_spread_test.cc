#include "validation/diagnosis/whole/whole_spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/suspend.h"
#include "tests/support/models.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

constexpr double kTorque = 0.03;   // [N m], of 0.1 that the robot's file gives a leg
constexpr double kStart = 1.2e-3;  // [s]
constexpr double kCount = 2 * M_PI / 4096;

// Some motions of a leg that hangs, with noise of their own.
WholeSpread spreadOf(double jitter) {
  RecordingPlan plan;
  plan.model = std::make_shared<RobotModel>(suspend(*test::robot("nao_h21_v33")));
  plan.joints = {"LHipRoll", "LHipPitch", "LKneePitch"};
  plan.motions = standardRecording(plan.model);
  plan.motions.resize(3);
  moveOnly(plan.joints, plan.model, plan.motions);
  plan.repeats = 6;
  plan.start_sd = kStart;
  plan.extra = {{"process_noise", {{"sd", kTorque}, {"time", 0.05}}, {}, ""},
                {"encoder_jitter", {{"amplitude", jitter}}, {}, ""}};
  const WholeSimulator simulator(recordSimulated(plan), plan.model);
  const WholeData data(simulator, simulator.joints(), false);
  return fitSpread(data, {}, 24, 2);
}

// Of ten sets like it, most of fewer motions, torques came out 0.29 to 0.40, 0.34 on the mean. Runs
// that begin apart, the chance of what they were compared with and encoders that jitter less than
// the robot's file says had all been told as torque: 0.58.
TEST(WholeSpread, OfALimbTellsTorqueFromStartsAndJitter) {
  const WholeSpread spread = spreadOf(0);
  EXPECT_NEAR(spread.noise.torque, kTorque / 0.1, 0.1);
  EXPECT_LT(spread.noise.jitter, 0.3);
  // Eighteen runs, less a mean for each motion: three SDs of their own.
  EXPECT_NEAR(spread.noise.start_sd, kStart, 3 * kStart / std::sqrt(30.0));
  EXPECT_TRUE(spread.differs);
}

TEST(WholeSpread, OfALimbTellsHowMuchItsEncodersJitter) {
  const WholeSpread spread = spreadOf(kCount);
  EXPECT_NEAR(spread.noise.torque, kTorque / 0.1, 0.1);
  EXPECT_NEAR(spread.noise.jitter, 1, 0.15);
}

}  // namespace
}  // namespace nao::validation
