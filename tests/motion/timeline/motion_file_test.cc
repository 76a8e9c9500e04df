#include "motion/timeline/motion_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "core/check.h"
#include "motion/trajectory.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kExact = 1e-9;

const std::string kMotions = NAO_SOURCE_DIR "/../shared/motions/";

std::string errorOf(const std::string& text, const std::string& source) {
  try {
    readMotion(text, source, *makeTestRobot());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string animation(const std::string& curves) {
  return "<?xml version=\"1.0\"?>\n<Animation typeVersion=\"2.0\" "
         "xmlns:editor=\"http://www.ald.softbankrobotics.com/animation/editor\">\n" +
         curves + "</Animation>\n";
}

TEST(Qianim, CurvesHaveTheirOwnFrameRateAndUnit) {
  const auto robot = makeTestRobot();
  const Timeline timeline = readMotion(
      animation("<ActuatorCurve fps=\"25\" actuator=\"HeadYaw\" mute=\"false\" unit=\"degree\">"
                "<Key value=\"90\" frame=\"50\"/></ActuatorCurve>\n"
                "<ActuatorCurve fps=\"10\" actuator=\"HeadPitch\" mute=\"0\" unit=\"radian\">"
                "<Key value=\"0.25\" frame=\"5\"><Tangent side=\"right\" "
                "editor:interpType=\"bezier\" abscissaParam=\"2\" ordinateParam=\"0.1\"/></Key>"
                "<Key value=\"0.5\" frame=\"15\"/></ActuatorCurve>\n"),
      "idle.qianim", *robot);
  ASSERT_EQ(timeline.curves.size(), 2u);
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 2, kExact);
  EXPECT_NEAR(timeline.curves[0].keys[0].angle, 90 * kDegree, kExact);
  const Key& key = timeline.curves[1].keys[0];
  EXPECT_NEAR(key.time, 0.5, kExact);
  EXPECT_NEAR(key.angle, 0.25, kExact);
  EXPECT_EQ(key.after.kind, Handle::Kind::Bezier);
  EXPECT_NEAR(key.after.dt, 0.2, kExact);
  EXPECT_NEAR(key.after.dangle, 0.1, kExact);
  EXPECT_NEAR(timeline.length, 2, kExact);
}

TEST(Qianim, WhatIsNoJointIsToldAndTheRestIsPlayed) {
  const Timeline timeline = readMotion(
      animation("<ActuatorCurve fps=\"25\" actuator=\"KneePitch\" unit=\"degree\"/>\n"
                "<ActuatorCurve fps=\"25\" actuator=\"X\" unit=\"meter\"/>\n"
                "<ActuatorCurve fps=\"25\" actuator=\"HeadPitch\" mute=\"true\" unit=\"degree\">"
                "<Key value=\"1\" frame=\"1\"/></ActuatorCurve>\n"
                "<ActuatorCurve fps=\"25\" actuator=\"HeadYaw\" unit=\"degree\">"
                "<Key value=\"1\" frame=\"1\"/></ActuatorCurve>\n"),
      "a.qianim", *makeTestRobot());
  EXPECT_EQ(timeline.curves.size(), 1u);
  ASSERT_EQ(timeline.warnings.size(), 2u);
  EXPECT_EQ(timeline.warnings[0], "a.qianim:3: this robot has no joint KneePitch");
  EXPECT_EQ(timeline.warnings[1], "a.qianim:4: X is in metres, not a joint of a Nao");
}

TEST(Qianim, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("<Animation>\n<Actuator", "a.qianim"),
            "a.qianim:2: no well-formed XML: the tag <Actuator is not well-formed; it is left out");
  EXPECT_EQ(errorOf("<Other/>", "a.qianim"), "a.qianim:1: expected an <Animation>");
  EXPECT_EQ(errorOf(animation("<ActuatorCurve actuator=\"HeadYaw\" unit=\"inch\"/>"), "a.qianim"),
            "a.qianim:3: unknown unit \"inch\", expected degree, radian or dimensionless (0 or 1 "
            "in a .xar)");
}

TEST(MotionFile, TheBeginningTellsTheKindWhereTheExtensionDoesNot) {
  const auto robot = makeTestRobot();
  EXPECT_NEAR(readMotion("#WEBOTS_MOTION,V1.0,HeadYaw\n00:02:000,a,1\n", "what", *robot).length, 2,
              kExact);
  EXPECT_EQ(errorOf("hello", "what").rfind("what:1: no motion file of a known kind", 0), 0u);
}

TEST(MotionFile, WhatHoldsNoJointAnglesIsRefusedWithTheReason) {
  EXPECT_EQ(errorOf("", "kick.kmc"),
            "kick.kmc:1: paths of feet and hands in space, not joint angles");
  EXPECT_EQ(errorOf("", "way.pmt"), "way.pmt:1: a path over the floor, not joint angles");
  EXPECT_THROW(loadMotion("/nowhere/a.xar", *makeTestRobot()), InputError);
}

struct Target {
  const char* file;
  double length;       // [s]
  const char* joint;   // is at ...
  double time, angle;  // [s], [rad]
};

// Figures read off the files: frame / fps (or the sum of durations), degrees to radians.
const Target kTargets[] = {
    {"Azi2333+Robocup-Simulation-with-8-players/TaiChi.motion", 50, "RAnkleRoll", 7, 0.397},
    {"Azi2333+Robocup-Simulation-with-8-players/Forwards50.motion", 6.76, "LKneePitch", 0.12,
     1.086},
    {"kouretes+Monas/getup.kme", 4.7, "RElbowYaw", 2, 1.862},
    {"kouretes+Monas/jackson_half.kme", 4, "LShoulderRoll", 3, 1.637},
    {"UNSWComputing+rUNSWift-2019-release/getupBack.pos", 5.05, "LHipPitch", 1.4, -55 * kDegree},
    {"UNSWComputing+rUNSWift-2019-release/goalieDiveLeft.pos", 2.4, "LElbowRoll", 2.4,
     -56 * kDegree},
    {"mxochicale+nao/macarena_naoqi21413__macarena__behavior.xar", 431 / 25.0, "HeadYaw", 48 / 25.0,
     -17.9323 * kDegree},
    {"kouretes+Monas/KickRightBest2013.xar", 69 / 10.0, "RShoulderPitch", 18 / 10.0,
     79.8033 * kDegree},
};

double angleAt(const Timeline& timeline, const RobotModel& model, const Target& target) {
  for (const Curve& curve : timeline.curves) {
    if (curve.joint != *model.findJoint(target.joint)) continue;
    return Trajectory(0, curve.keys).at(target.time);
  }
  return std::nan("");
}

TEST(MotionFile, LengthsAndTargetsOfOthersMotionsAreThoseInTheFiles) {
  if (!std::filesystem::exists(kMotions)) GTEST_SKIP() << "no " << kMotions << " here";
  const auto robot = makeTestRobot();
  for (const Target& target : kTargets) {
    const Timeline timeline = loadMotion(kMotions + target.file, *robot);
    EXPECT_NEAR(timeline.length, target.length, kExact) << target.file;
    EXPECT_NEAR(angleAt(timeline, *robot, target), target.angle, 1e-6) << target.file;
  }
}

// Every motion of others is played, or refused for one of the two reasons there are.
bool mayBeRefused(const std::string& reason) {
  return reason.find("not joint angles") != std::string::npos ||
         reason.find("would have to choose what to play") != std::string::npos;
}

TEST(MotionFile, EveryMotionOfOthersIsPlayedOrRefusedWithAReason) {
  if (!std::filesystem::exists(kMotions)) GTEST_SKIP() << "no " << kMotions << " here";
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kMotions)) {
    if (entry.is_regular_file() && entry.path().extension() != ".md") files.push_back(entry);
  }
  std::sort(files.begin(), files.end());
  std::map<std::string, std::pair<int, int>> counts;  // played and refused, by extension
  const auto robot = makeTestRobot();
  for (const auto& file : files) {
    const std::string extension = file.extension().string();
    try {
      const Timeline timeline = loadMotion(file, *robot);
      ++counts[extension].first;
      std::cout << file.filename().string() << ": " << timeline.length << " s, "
                << timeline.curves.size() << " joints, " << timeline.warnings.size()
                << " warnings\n";
      EXPECT_FALSE(timeline.curves.empty()) << file;
      for (const Curve& curve : timeline.curves) {
        double before = 0;
        for (const Key& key : curve.keys) {
          EXPECT_GT(key.time, before) << file;
          before = key.time;
        }
        EXPECT_LE(before, timeline.length + kExact) << file;
      }
    } catch (const InputError& error) {
      ++counts[extension].second;
      std::cout << "refused: " << error.what() << "\n";
      EXPECT_TRUE(mayBeRefused(error.what())) << error.what();
      EXPECT_EQ(std::string(error.what()).rfind(file.string() + ":", 0), 0u) << error.what();
    }
  }
  for (const auto& [extension, count] : counts) {
    std::cout << extension << ": " << count.first << " played, " << count.second << " refused\n";
  }
  EXPECT_FALSE(files.empty());
}

}  // namespace
}  // namespace nao::motion
