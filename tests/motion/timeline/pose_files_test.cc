// Motion files that are rows of poses, each read from a small text of our own.
#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "motion/trajectory.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kExact = 1e-12;

std::shared_ptr<RobotModel> robotWithHands() {
  auto robot = makeTestRobot();
  for (const char* name : {"LHand", "RHand"}) {
    Actuator hand;
    hand.name = name;
    hand.upper = 1;
    robot->actuators.push_back(hand);
  }
  return robot;
}

Timeline read(const std::string& text, const std::string& source) {
  return readMotion(text, source, *robotWithHands());
}

std::string errorOf(const std::string& text, const std::string& source) {
  try {
    read(text, source);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Key> keysOf(const Timeline& timeline, const char* joint) {
  for (const Curve& curve : timeline.curves) {
    if (curve.joint == *robotWithHands()->findJoint(joint)) return curve.keys;
  }
  return {};
}

const std::string kWave =
    "#WEBOTS_MOTION,V1.0,HeadYaw,HeadPitch\n"
    "00:01:000,a,0.5,-0.25\n"
    "00:01:500,b,*,0.25\n"
    "01:02:040,c,-0.5,0\n";

TEST(WebotsMotion, RowsAreMinutesSecondsMillisecondsAndRadians) {
  const Timeline timeline = read(kWave, "wave.motion");
  const auto pitch = keysOf(timeline, "HeadPitch");
  ASSERT_EQ(pitch.size(), 3u);
  EXPECT_NEAR(pitch[1].time, 1.5, kExact);
  EXPECT_NEAR(pitch[1].angle, 0.25, kExact);
  EXPECT_NEAR(pitch[2].time, 62.04, kExact);
  EXPECT_NEAR(timeline.length, 62.04, kExact);
  EXPECT_TRUE(timeline.warnings.empty());
}

TEST(WebotsMotion, AStarKeepsOnAlongTheLine) {
  const auto yaw = keysOf(read(kWave, "wave.motion"), "HeadYaw");
  ASSERT_EQ(yaw.size(), 2u);  // the line goes on to the next value that is told
  const Trajectory course(0, yaw);
  const double part = (1.5 - 1.0) / (62.04 - 1.0);
  EXPECT_NEAR(course.at(1.5), 0.5 - part, 1e-9);
}

TEST(WebotsMotion, ThePoseAtTimeZeroIsReachedWithinACycle) {
  const Timeline timeline = read(
      "#WEBOTS_MOTION,V1.0,HeadYaw\n00:00:000,a,1\n00:00:030,b,0.5\n00:02:000,c,0\n", "a.motion");
  const auto yaw = keysOf(timeline, "HeadYaw");
  ASSERT_EQ(yaw.size(), 3u);
  EXPECT_NEAR(yaw[0].time, 0.015, kExact);
  EXPECT_NEAR(yaw[0].angle, 1, kExact);
}

TEST(WebotsMotion, TheFirstFingerStandsForTheHand) {
  const Timeline timeline = read(
      "#WEBOTS_MOTION,V1.0,LPhalanx1,LPhalanx2,LPhalanx8,RPhalanx1\n00:01:000,a,0.25,1,1,0.5\n",
      "hands.motion");
  EXPECT_EQ(timeline.curves.size(), 2u);
  EXPECT_NEAR(keysOf(timeline, "LHand").at(0).angle, 0.25, kExact);
  EXPECT_NEAR(keysOf(timeline, "RHand").at(0).angle, 0.5, kExact);
  EXPECT_TRUE(timeline.warnings.empty());
}

TEST(WebotsMotion, UnknownJointsAndShortRowsAreToldAndTheRestIsPlayed) {
  const Timeline timeline =
      read("#WEBOTS_MOTION,V1.0,HeadYaw,Wheel,HeadPitch\n00:01:000,a,1,2,3\n00:02:000,b,4\n",
           "a.motion");
  EXPECT_EQ(keysOf(timeline, "HeadYaw").size(), 2u);
  EXPECT_EQ(keysOf(timeline, "HeadPitch").size(), 1u);
  EXPECT_EQ(timeline.warnings,
            std::vector<std::string>{"a.motion:1: this robot has no joint Wheel"});
  EXPECT_EQ(timeline.broken,
            std::vector<std::string>{"a.motion:3: this row has 1 values for 3 joints"});
}

TEST(WebotsMotion, WhatCanNotBeReadOfARowIsToldAndTheRestIsPlayed) {
  const Timeline timeline = read(
      "#WEBOTS_MOTION,V1.0,HeadYaw,HeadPitch\n00:01:000,a,1,x\n00:01:000,b,9,9\n00:02:000,c,2,3\n",
      "a.motion");
  EXPECT_EQ(keysOf(timeline, "HeadYaw").size(), 2u);
  EXPECT_EQ(keysOf(timeline, "HeadPitch").size(), 1u);
  EXPECT_EQ(timeline.broken, (std::vector<std::string>{
                                 "a.motion:2: a joint's value must be a number, not \"x\"",
                                 "a.motion:3: the time must be later than that of the row above"}));
}

TEST(WebotsMotion, WhatIsWrongIsToldWithItsLine) {
  const std::string head = "#WEBOTS_MOTION,V1.0,HeadYaw\n";
  EXPECT_EQ(errorOf("HeadYaw\n", "a.motion"),
            "a.motion:1: expected the line #WEBOTS_MOTION,V1.0,<names of joints>");
  EXPECT_EQ(errorOf("", "a.motion"),
            "a.motion:1: expected the line #WEBOTS_MOTION,V1.0,<names of joints>");
  EXPECT_EQ(errorOf(head + "00:01:000,a,x1\n", "a.motion"),
            "a.motion:2: a joint's value must be a number, not \"x1\"");
  EXPECT_EQ(errorOf(head + "1.5,a,1\n", "a.motion"),
            "a.motion:2: expected a time MM:SS:mmm, not \"1.5\"");
  EXPECT_EQ(errorOf(head, "a.motion"), "a.motion:1: nothing here moves a joint of this robot");
}

TEST(Kme, RowsAreRadiansInTheOrderOfTheTeamAndSeconds) {
  std::string row = "play";
  for (int i = 0; i < 22; ++i) row += "%0." + std::to_string(10 + i);
  const Timeline timeline = read(row + "%0.5\n" + row + "%1.250\n", "up.kme");
  EXPECT_EQ(timeline.curves.size(), 21u);  // both hip yaw-pitches are one motor
  EXPECT_NEAR(timeline.length, 1.75, kExact);
  EXPECT_NEAR(keysOf(timeline, "HeadYaw").at(0).angle, 0.10, kExact);
  EXPECT_NEAR(keysOf(timeline, "LHipYawPitch").at(0).angle, 0.16, kExact);
  EXPECT_NEAR(keysOf(timeline, "RHipRoll").at(0).angle, 0.23, kExact);
  EXPECT_NEAR(keysOf(timeline, "RElbowRoll").at(1).angle, 0.31, kExact);
  const Timeline rest = read(row + "%0.5\nplay%1%2\n" + row + "%0.5\n", "up.kme");
  EXPECT_NEAR(rest.length, 1.0, kExact);
  EXPECT_EQ(rest.broken, std::vector<std::string>{"up.kme:2: expected 22 angles and a duration, "
                                                  "not 2 values"});
  EXPECT_EQ(errorOf(row + "%0\n", "up.kme"), "up.kme:1: the duration must be positive");
}

TEST(Pos, RowsAreDegreesAndMilliseconds) {
  const Timeline timeline = read(
      "  HY HP LH DUR\nsome text\n$ 1 1 1\n! 90 -10 0.5 600\n#! 1 1 1 1\n! 0 20 1 400\n", "up.pos");
  EXPECT_NEAR(timeline.length, 1.0, kExact);
  const auto pitch = keysOf(timeline, "HeadPitch");
  ASSERT_EQ(pitch.size(), 2u);
  EXPECT_NEAR(pitch[0].time, 0.6, kExact);
  EXPECT_NEAR(pitch[0].angle, -10 * kDegree, kExact);
  EXPECT_NEAR(pitch[1].angle, 20 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "LHand").at(0).angle, 0.5, kExact);
  ASSERT_EQ(timeline.warnings.size(), 1u);
  EXPECT_EQ(timeline.warnings[0],
            "up.pos:3: stiffness is not part of a timeline; it stays as it is set");
}

TEST(Pos, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("HY HP DUR\n! 1 2\n", "up.pos"),
            "up.pos:2: expected 2 angles and a duration, not 2 values");
  EXPECT_EQ(errorOf("HY XX DUR\n", "up.pos"), "up.pos:1: unknown joint code XX");
  EXPECT_EQ(errorOf("! 1 2\n", "up.pos"),
            "up.pos:1: expected a line of joint codes that ends in DUR");
}

}  // namespace
}  // namespace nao::motion
