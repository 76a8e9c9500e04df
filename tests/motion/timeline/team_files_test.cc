// Motions as robot-soccer teams write them, each a small text of our own.
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

std::string errorOf(const std::string& text, const std::string& source) {
  try {
    readMotion(text, source, *makeTestRobot());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Key> keysOf(const Timeline& timeline, const char* joint) {
  for (const Curve& curve : timeline.curves) {
    if (curve.joint == *makeTestRobot()->findJoint(joint)) return curve.keys;
  }
  return {};
}

// 26 columns, all `rest` but those of HeadYaw, LShoulderPitch and RAnkleRoll.
std::string mofRow(const char* yaw, const char* shoulder, const char* ankle, const char* rest,
                   const std::string& end) {
  std::string row = std::string(yaw) + " " + rest + " " + shoulder;
  for (int i = 0; i < 22; ++i) row += std::string(" ") + rest;
  return row + " " + ankle + " " + end + "\n";
}

TEST(Mof, RowsAreDegreesAndMilliseconds) {
  const Timeline timeline = readMotion(
      "motion_id = nod\n\"nod 1 2\nlabel start\n\nstiffness 50 10\n" +
          mofRow("10", "90", "-5", "0", "1 150") + mofRow("-", "*", "5", "-", "1 250 \"there") +
          "transition allMotions extern start\n",
      "nod.mof", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 0.4, kExact);
  EXPECT_NEAR(keysOf(timeline, "HeadYaw").at(0).angle, 10 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "HeadYaw").at(1).angle, 10 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "LShoulderPitch").at(0).angle, 90 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "RAnkleRoll").at(0).time, 0.15, kExact);
  EXPECT_NEAR(keysOf(timeline, "RAnkleRoll").at(1).time, 0.4, kExact);
  EXPECT_NEAR(keysOf(timeline, "RAnkleRoll").at(1).angle, 5 * kDegree, kExact);
}

TEST(Mof, WithoutInterpolationTheJointJumpsAndStays) {
  const Timeline timeline =
      readMotion(mofRow("0", "0", "0", "0", "1 500") + mofRow("30", "-", "-", "-", "0 500"),
                 "jump.mof", *makeTestRobot());
  const Trajectory yaw(0, keysOf(timeline, "HeadYaw"));
  EXPECT_NEAR(yaw.at(0.5), 0, kExact);
  EXPECT_NEAR(yaw.at(0.53), 30 * kDegree, kExact);
  EXPECT_NEAR(yaw.at(1.0), 30 * kDegree, kExact);
}

TEST(Mof, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("motion_id = a\n1 2 3\n", "a.mof"),
            "a.mof:2: expected 26 angles, Int and Dur, not 3 values");
  EXPECT_EQ(errorOf(mofRow("x", "x", "x", "x", "1 100"), "a.mof"),
            "a.mof:1: an angle must be a number, not \"x\"");
  EXPECT_EQ(errorOf(mofRow("0", "0", "0", "0", "1 0"), "a.mof"), "a.mof:1: Dur must be positive");
  EXPECT_EQ(errorOf("0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 1 100\n", "a.mof"),
            "a.mof:1: a row of 22 joints is of the years before 2016, whose signs are not known");
}

TEST(Mof, WhatCanNotBeReadIsToldAndTheRestIsPlayed) {
  const Timeline timeline = readMotion(
      mofRow("1", "1", "0", "0", "1 100") + "1 2 3\n" + mofRow("x", "2", "0", "0", "1 100"),
      "a.mof", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 0.2, kExact);
  EXPECT_EQ(keysOf(timeline, "HeadYaw").size(), 1u);
  EXPECT_EQ(keysOf(timeline, "LShoulderPitch").size(), 2u);
  EXPECT_EQ(timeline.broken,
            (std::vector<std::string>{"a.mof:2: expected 26 angles, Int and Dur, not 3 values",
                                      "a.mof:3: an angle must be a number, not \"x\""}));
}

std::string kfmFrame(const std::string& head, const std::string& end) {
  return "  {\n    headAngles = [" + head +
         "]; // of two\n    armsAngles = [20000,20000,20000,20000,20000,20000, "
         "20000,20000,20000,20000,20000,20000];\n"
         "    legsAngles = [0,0,-21deg,0,0,0, 0,0,0.5,0,0,0];\n    " +
         end + "\n  }";
}

TEST(Kfm, AnglesAreRadiansOrDegreesAndKeepTheirPlace) {
  const Timeline timeline =
      readMotion("//mine\nkeyFrameID = nod;\nkeyFrames = [\n" +
                     kfmFrame("10deg,0.25", "duration = 400; intType = linear;") + ",\n" +
                     kfmFrame("20000,-0.25", "duration = 600; intType = sine;") + "\n];\n",
                 "nod.kfm", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 1.0, kExact);
  EXPECT_TRUE(keysOf(timeline, "LShoulderPitch").empty());
  EXPECT_NEAR(keysOf(timeline, "HeadYaw").at(1).angle, 10 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "LHipPitch").at(0).angle, -21 * kDegree, kExact);
  EXPECT_NEAR(keysOf(timeline, "RHipPitch").at(0).angle, 0.5, kExact);
  // A sine is level at its ends and half way in the middle.
  const Trajectory pitch(0, keysOf(timeline, "HeadPitch"));
  EXPECT_NEAR(pitch.at(0.7), 0, 1e-9);
  EXPECT_NEAR(pitch.at(0.41), 0.25, 0.001);
  EXPECT_NEAR(pitch.at(0.99), -0.25, 0.001);
}

TEST(Kfm, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("a = 1;\n", "a.kfm"), "a.kfm:1: expected keyFrames = [...]");
  EXPECT_EQ(errorOf("keyFrames = [\n" + kfmFrame("1", "duration = 1;") + "\n];", "a.kfm"),
            "a.kfm:3: headAngles must have 2 values, not 1");
  EXPECT_EQ(errorOf("keyFrames = [\n" + kfmFrame("1,2", "") + "\n];", "a.kfm"),
            "a.kfm:2: the key frame lacks its duration");
  EXPECT_EQ(errorOf("keyFrames = [\n{\n", "a.kfm"), "a.kfm:3: expected a closing }");
}

TEST(Kfm, FramesBeforeABreakArePlayedAndTheBreakIsTold) {
  const std::string whole = kfmFrame("1,2", "duration = 400;");
  const Timeline timeline =
      readMotion("keyFrames = [\n" + whole + ",\n" + kfmFrame("1", "duration = 400;") + ",\n" +
                     whole + ",\n{\n headAngles = [1,",
                 "a.kfm", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 0.8, kExact);
  ASSERT_EQ(timeline.broken.size(), 3u);
  EXPECT_EQ(timeline.broken[0], "a.kfm:21: expected a closing ]");
  EXPECT_EQ(timeline.broken[1], "a.kfm:9: headAngles must have 2 values, not 1");
  EXPECT_EQ(timeline.broken[2], "a.kfm:20: the key frame lacks its duration");
}

TEST(Hulks, PartsAndJointsGoByNameInRadiansAndSeconds) {
  const Timeline timeline = readMotion(
      "{\n\"initial_positions\": {\"head\": {\"yaw\": 0.5}},\n\"motion\": [{\"keyframes\": [\n"
      "{\"duration\": 0.25, \"positions\": {\"head\": {\"yaw\": 1, \"pitch\": 0.1},\n"
      "  \"left_arm\": {\"shoulder_pitch\": -0.5}, \"right_leg\": {\"hip_yaw_pitch\": -0.3}}},\n"
      "{\"duration\": 0.5, \"positions\": {\"head\": {\"yaw\": 0}}}],\n"
      "\"exit_condition\": {\"x\": 1}}]}\n",
      "up.json", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 0.75, kExact);
  const auto yaw = keysOf(timeline, "HeadYaw");
  ASSERT_EQ(yaw.size(), 3u);
  EXPECT_NEAR(yaw[0].time, 0.02, kExact);
  EXPECT_NEAR(yaw[1].time, 0.25, kExact);
  EXPECT_NEAR(keysOf(timeline, "LShoulderPitch").at(0).angle, -0.5, kExact);
  EXPECT_NEAR(keysOf(timeline, "LHipYawPitch").at(0).angle, -0.3, kExact);
  ASSERT_EQ(timeline.warnings.size(), 1u);
  EXPECT_EQ(timeline.warnings[0], "up.json:7: the exit_condition is not waited for");
}

TEST(Hulks, FramesBeforeABreakArePlayedAndTheBreakIsTold) {
  const Timeline timeline = readMotion(
      "{\"motion\": [{\"keyframes\": [\n"
      "{\"duration\": 0.25, \"positions\": {\"head\": {\"yaw\": 1, \"pitch\": \"?\"}}},\n"
      "{\"positions\": {}},\n{\"duration\": 0.5, \"positions\": {\"head\": {\"yaw\" 0}}}]}]}",
      "a.json", *makeTestRobot());
  EXPECT_NEAR(timeline.length, 0.75, kExact);
  EXPECT_EQ(keysOf(timeline, "HeadYaw").size(), 2u);  // the second: stays
  EXPECT_EQ(timeline.broken,
            (std::vector<std::string>{"a.json:4: expected a name and a value",
                                      "a.json:2: a position must be a number, not \"?\"",
                                      "a.json:3: expected a member duration"}));
}

TEST(Hulks, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("{\"a\": 1}", "a.json"), "a.json:1: expected a member motion");
  EXPECT_EQ(errorOf("{\n\"motion\" 1}", "a.json"), "a.json:2: expected a name and a value");
  EXPECT_EQ(errorOf("{\"motion\": [{\"keyframes\": [\n{\"duration\": 0, \"positions\": {}}]}]}",
                    "a.json"),
            "a.json:2: the duration must be positive");
}

}  // namespace
}  // namespace nao::motion
