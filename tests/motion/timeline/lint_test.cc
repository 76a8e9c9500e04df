#include "motion/timeline/lint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "motion/timeline/motion_file.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Kind = MotionFault::Kind;
constexpr double kDegree = M_PI / 180;

// A timeline of 10 frames a second from frame 1 on, with these curves.
std::string behavior(const std::string& curves) {
  return "<ChoregrapheProject xar_version=\"3\"><Box name=\"root\" id=\"-1\"><Timeline "
         "enable=\"1\" fps=\"10\" start_frame=\"1\" end_frame=\"40\"><ActuatorList>\n" +
         curves + "</ActuatorList></Timeline></Box></ChoregrapheProject>";
}

std::string curve(const std::string& joint, const std::string& keys) {
  return "<ActuatorCurve actuator=\"" + joint + "\" unit=\"0\">" + keys + "</ActuatorCurve>\n";
}

std::string key(int frame, double value) {
  return "<Key frame=\"" + std::to_string(frame) + "\" value=\"" + std::to_string(value) + "\"/>";
}

std::vector<MotionFault> faultsOf(const std::string& curves) {
  const auto robot = makeTestRobot();
  const Timeline timeline = readMotion(behavior(curves), "a.xar", *robot);
  const JointArray<double> start(robot->jointCount(), 0.0);
  std::vector<MotionFault> faults = lint(timeline, *robot, start);
  describeFaults(timeline, *robot, faults);
  return faults;
}

std::vector<MotionFault> only(const std::vector<MotionFault>& faults, Kind kind) {
  std::vector<MotionFault> found;
  std::copy_if(faults.begin(), faults.end(), std::back_inserter(found),
               [kind](const MotionFault& fault) { return fault.kind == kind; });
  return found;
}

// The test robot's knees and elbows are beyond their limits at 0 themselves; these joints are not.
std::vector<MotionFault> ofJoint(const std::vector<MotionFault>& faults, const char* name) {
  const Joint joint = *makeTestRobot()->findJoint(name);
  std::vector<MotionFault> found;
  std::copy_if(faults.begin(), faults.end(), std::back_inserter(found),
               [joint](const MotionFault& fault) { return fault.joint == joint; });
  return found;
}

TEST(Lint, AQuietMotionHasNoFaults) {
  EXPECT_TRUE(ofJoint(faultsOf(curve("HeadYaw", key(21, 30))), "HeadYaw").empty());
}

TEST(Lint, AnAngleBeyondTheLimitIsToldWithItsFrameAndItsWorst) {
  const auto faults =
      only(ofJoint(faultsOf(curve("HeadYaw", key(11, 0) + key(21, 150) + key(31, 0))), "HeadYaw"),
           Kind::JointLimit);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].value, 150 * kDegree, 1e-3);
  EXPECT_NEAR(faults[0].limit, 2.0857, 1e-9);
  EXPECT_GT(faults[0].frame, 11);
  EXPECT_LT(faults[0].frame, 21);
  EXPECT_GT(faults[0].until, 2.0);
  EXPECT_EQ(faults[0].text, "HeadYaw: asked for 150.0 degrees, its limit is 119.5 degrees");
}

TEST(Lint, ACoupledLimitIsThatOfTheDriversAngleAtThatMoment) {
  const std::string nod = curve("HeadPitch", key(21, 25));
  EXPECT_TRUE(only(faultsOf(nod), Kind::CoupledLimit).empty());
  const auto faults = only(faultsOf(nod + curve("HeadYaw", key(21, 87.7))), Kind::CoupledLimit);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].value, 25 * kDegree, 1e-3);
  EXPECT_NEAR(faults[0].limit, 0.2, 1e-3);
  EXPECT_NE(faults[0].text.find("HeadYaw leaves it"), std::string::npos) << faults[0].text;
}

TEST(Lint, ASpeedThatNoMotorHasIsTold) {
  const auto slow = faultsOf(curve("HeadYaw", key(11, 0) + key(21, 90)));
  EXPECT_TRUE(only(ofJoint(slow, "HeadYaw"), Kind::Velocity).empty());
  const auto faults = only(ofJoint(faultsOf(curve("HeadYaw", key(11, 0) + key(12, 90))), "HeadYaw"),
                           Kind::Velocity);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NEAR(faults[0].limit, 8.268, 1e-9);
  EXPECT_GT(faults[0].value, 90 * kDegree / 0.1);  // faster in the middle than on average
  EXPECT_NEAR(faults[0].frame, 11.5, 0.5);
}

TEST(Lint, KeysThatCanNotBePlayedAsWrittenAreToldWithTheirLine) {
  const auto faults = only(
      faultsOf(curve("HeadYaw", key(1, 10) + key(30, 3) + key(20, 5)) +
               curve("LHipRoll", key(10, 1) + key(10, 2) + key(50, 3)) + curve("LHipPitch", "")),
      Kind::Key);
  std::vector<std::string> texts;
  for (const MotionFault& fault : faults) texts.push_back(fault.text);
  const auto has = [&](const char* text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
  };
  EXPECT_EQ(texts.size(), 5u);
  EXPECT_TRUE(
      has("a.xar:2: HeadYaw: this key is at time 0 or before; it is played half a frame "
          "later"));
  EXPECT_TRUE(
      has("a.xar:2: HeadYaw: the keys are not in order of their frames; they are played "
          "in order"));
  EXPECT_TRUE(has("a.xar:3: LHipRoll: there are two keys on this frame; the last one is played"));
  EXPECT_TRUE(has("a.xar:3: LHipRoll: this key is after the end of the timeline and is left out"));
  EXPECT_TRUE(has("a.xar:4: LHipPitch has no keys"));
}

TEST(Lint, ARowAtTimeZeroIsToldOnce) {
  const auto robot = makeTestRobot();
  const Timeline timeline =
      readMotion("#WEBOTS_MOTION,V1.0,HeadYaw,HeadPitch\n00:00:000,a,0.1,0.1\n00:01:000,b,0,0\n",
                 "a.motion", *robot);
  ASSERT_EQ(timeline.key_faults.size(), 1u);
  EXPECT_EQ(timeline.key_faults[0].sentence.rfind("a.motion:2: this row is at time 0", 0), 0u);
}

TEST(FaultLog, MomentsFurtherApartThanItsGapAreTwoFaults) {
  FaultLog log;
  for (const double time : {1.0, 1.05, 1.12, 1.3}) log.add({Kind::Fall, {}, time, time, 0, {}});
  const auto faults = log.take();
  ASSERT_EQ(faults.size(), 2u);
  EXPECT_EQ(faults[0].time, 1.0);
  EXPECT_EQ(faults[0].until, 1.12);
  EXPECT_EQ(faults[0].value, 1.12);
  EXPECT_EQ(faults[1].time, 1.3);
}

TEST(FrameAt, CountsKeysWhereAFileHasNoFrames) {
  const auto robot = makeTestRobot();
  const Timeline timeline = readMotion(
      "#WEBOTS_MOTION,V1.0,HeadYaw\n00:01:000,a,0.1\n00:03:000,b,0\n", "a.motion", *robot);
  const Joint yaw = *robot->findJoint("HeadYaw");
  EXPECT_EQ(frameAt(timeline, yaw, 0.5), 0);
  EXPECT_EQ(frameAt(timeline, yaw, 1.0), 1);
  EXPECT_EQ(frameAt(timeline, {}, 5.0), 2);
}

}  // namespace
}  // namespace nao::motion
