#include "motion/timeline/xar.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/check.h"
#include "motion/trajectory.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kExact = 1e-12;

// A behavior whose root holds one diagram with these boxes and links.
std::string project(const std::string& boxes_and_links) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n"
         "<ChoregrapheProject xar_version=\"3\"><Box name=\"root\" id=\"-1\">"
         "<Timeline enable=\"0\"><BehaviorLayer><BehaviorKeyframe index=\"1\"><Diagram>" +
         boxes_and_links +
         "</Diagram></BehaviorKeyframe></BehaviorLayer></Timeline></Box></ChoregrapheProject>";
}

std::string box(const std::string& id, const std::string& timeline_attributes,
                const std::string& curves) {
  return "<Box name=\"box" + id + "\" id=\"" + id +
         "\"><Input name=\"onStart\" nature=\"2\" id=\"2\"/><Input name=\"onStop\" nature=\"3\" "
         "id=\"3\"/><Timeline enable=\"1\" " +
         timeline_attributes + "><ActuatorList>" + curves + "</ActuatorList></Timeline></Box>";
}

std::string curve(const std::string& joint, const std::string& keys,
                  const std::string& more = "unit=\"0\"") {
  return "<ActuatorCurve actuator=\"" + joint + "\" " + more + ">" + keys + "</ActuatorCurve>";
}

std::string link(const std::string& from, const std::string& to) {
  return "<Link inputowner=\"" + to + "\" indexofinput=\"2\" outputowner=\"" + from +
         "\" indexofoutput=\"" + (from == "0" ? "2" : "4") + "\"/>";
}

const std::string kYawTo90 = "<Key frame=\"26\" value=\"90\"/>";

Timeline read(const std::string& text) { return readXar(text, "test.xar", *makeTestRobot()); }

std::string errorOf(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Xar, KeysBecomeSecondsAndRadians) {
  const Timeline timeline =
      read(project(box("1", "fps=\"25\" start_frame=\"1\"", curve("HeadYaw", kYawTo90))));
  ASSERT_EQ(timeline.curves.size(), 1u);
  ASSERT_EQ(timeline.curves[0].keys.size(), 1u);
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 1.0, kExact);
  EXPECT_NEAR(timeline.curves[0].keys[0].angle, 90 * kDegree, kExact);
  EXPECT_NEAR(timeline.length, 1.0, kExact);
}

TEST(Xar, FrameRatesBelowOneASecondCount) {
  const Timeline timeline = read(project(
      box("1", "fps=\"1\" start_frame=\"0\"", curve("HeadYaw", "<Key frame=\"3\" value=\"1\"/>"))));
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 3.0, kExact);
}

TEST(Xar, AKeyOnTheFirstFrameTakesHalfAFrame) {
  const Timeline timeline = read(project(
      box("1", "fps=\"10\" start_frame=\"1\"",
          curve("HeadYaw", "<Key frame=\"1\" value=\"5\"/><Key frame=\"11\" value=\"10\"/>"))));
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 0.05, kExact);
  EXPECT_NEAR(timeline.curves[0].keys[1].time, 1.0, kExact);
}

TEST(Xar, TheLastFrameCutsTheCurves) {
  const Timeline timeline = read(project(
      box("1", "fps=\"10\" start_frame=\"0\" end_frame=\"10\"",
          curve("HeadYaw", "<Key frame=\"5\" value=\"5\"/><Key frame=\"20\" value=\"10\"/>"))));
  const auto& keys = timeline.curves[0].keys;
  ASSERT_EQ(keys.size(), 2u);  // the one that is left, and that it holds until the end
  EXPECT_NEAR(keys[0].time, 0.5, kExact);
  EXPECT_NEAR(keys[1].time, 1.0, kExact);
  EXPECT_EQ(keys[1].angle, keys[0].angle);
  EXPECT_EQ(Trajectory(0, keys).at(0.8), keys[0].angle);
  EXPECT_NEAR(timeline.length, 1.0, kExact);
}

TEST(Xar, KeysWithoutTangentsAreAutomatic) {
  const Timeline timeline =
      read(project(box("1", "fps=\"10\" start_frame=\"0\"",
                       curve("HeadYaw",
                             "<Key frame=\"10\" value=\"0\"/><Key frame=\"20\" value=\"10\"/>"
                             "<Key frame=\"40\" value=\"40\"/>"))));
  const auto& keys = timeline.curves[0].keys;
  // The middle key rises with the slope of its neighbours, a third of either interval long.
  const double slope = 40 * kDegree / 3;
  EXPECT_NEAR(keys[1].after.dt, 2.0 / 3, kExact);
  EXPECT_NEAR(keys[1].after.dangle, slope * 2 / 3, kExact);
  EXPECT_NEAR(keys[1].before.dangle, -slope / 3, kExact);
  EXPECT_NEAR(keys[2].before.dangle, 0, kExact);
}

TEST(Xar, TangentsAreFramesAndDegrees) {
  const std::string keys =
      "<Key frame=\"10\" value=\"0\"><Tangent side=\"right\" interpType=\"bezier\" "
      "abscissaParam=\"5\" ordinateParam=\"9\"/></Key><Key frame=\"20\" value=\"10\">"
      "<Tangent side=\"left\" interpType=\"linear\" abscissaParam=\"-3\" ordinateParam=\"0\"/>"
      "</Key>";
  const Timeline timeline =
      read(project(box("1", "fps=\"10\" start_frame=\"0\"", curve("HeadYaw", keys))));
  const auto& read_keys = timeline.curves[0].keys;
  EXPECT_EQ(read_keys[0].after.kind, Handle::Kind::Bezier);
  EXPECT_NEAR(read_keys[0].after.dt, 0.5, kExact);
  EXPECT_NEAR(read_keys[0].after.dangle, 9 * kDegree, kExact);
  EXPECT_EQ(read_keys[1].before.kind, Handle::Kind::Linear);
}

TEST(Xar, MutedCurvesAndUnknownJointsAreLeftOut) {
  const Timeline timeline =
      read(project(box("1", "fps=\"25\" start_frame=\"1\"",
                       curve("HeadYaw", kYawTo90) + curve("HeadPitch", kYawTo90, "mute=\"1\"") +
                           curve("KneePitch", kYawTo90))));
  EXPECT_EQ(timeline.curves.size(), 1u);
  ASSERT_EQ(timeline.warnings.size(), 1u);
  EXPECT_EQ(timeline.warnings[0], "test.xar:2: this robot has no joint KneePitch");
}

TEST(Xar, TheLeftHipYawPitchWins) {
  const auto robot = makeTestRobot();
  const std::string both = curve("RHipYawPitch", "<Key frame=\"26\" value=\"-1\"/>") +
                           curve("LHipYawPitch", "<Key frame=\"26\" value=\"-9\"/>");
  const Timeline timeline = read(project(box("1", "fps=\"25\" start_frame=\"1\"", both)));
  ASSERT_EQ(timeline.curves.size(), 1u);
  EXPECT_NEAR(timeline.curves[0].keys[0].angle, -9 * kDegree, kExact);
  const Timeline right_only =
      read(project(box("1", "fps=\"25\" start_frame=\"1\"", curve("RHipYawPitch", kYawTo90))));
  EXPECT_EQ(right_only.curves[0].joint, *robot->findJoint("LHipYawPitch"));
}

TEST(Xar, HandsAreRawOrPercent) {
  auto robot = makeTestRobot();
  Actuator hand;
  hand.name = "LHand";
  hand.upper = 1;
  robot->actuators.push_back(hand);
  const auto openingOf = [&](const char* unit, const char* value) {
    const std::string key = std::string("<Key frame=\"26\" value=\"") + value + "\"/>";
    const std::string text =
        project(box("1", "fps=\"25\" start_frame=\"1\"", curve("LHand", key, unit)));
    return readXar(text, "test.xar", *robot).curves[0].keys[0].angle;
  };
  EXPECT_NEAR(openingOf("unit=\"1\"", "0.6"), 0.6, kExact);
  EXPECT_NEAR(openingOf("", "0.6"), 0.6, kExact);
  EXPECT_NEAR(openingOf("unit=\"1\"", "60"), 0.6, kExact);
}

TEST(Xar, LinkedBoxesPlayOneAfterTheOther) {
  const std::string clock = "fps=\"25\" start_frame=\"1\"";
  const Timeline timeline =
      read(project(box("1", clock, curve("HeadYaw", kYawTo90)) +
                   box("2", clock, curve("HeadYaw", "<Key frame=\"51\" value=\"0\"/>")) +
                   box("3", clock, curve("HeadPitch", kYawTo90)) + link("0", "1") + link("1", "2") +
                   link("1", "3")));
  ASSERT_EQ(timeline.curves.size(), 2u);
  const Trajectory yaw(0, timeline.curves[0].keys);
  EXPECT_NEAR(yaw.at(1), 90 * kDegree, 1e-9);
  EXPECT_NEAR(yaw.at(3), 0, 1e-9);
  // The pitch has nothing to do before its box begins; its first key is a second into it.
  EXPECT_NEAR(timeline.curves[1].keys[0].time, 2, kExact);
  EXPECT_NEAR(timeline.length, 3, kExact);
}

TEST(Xar, AJointHoldsUntilItsNextBox) {
  const std::string clock = "fps=\"25\" start_frame=\"1\"";
  const std::string key_at_half = "<Key frame=\"13.5\" value=\"90\"/>";
  const Timeline timeline =
      read(project(box("1", clock + " end_frame=\"51\"", curve("HeadYaw", key_at_half)) +
                   box("2", clock, curve("HeadYaw", "<Key frame=\"26\" value=\"0\"/>")) +
                   link("0", "1") + link("1", "2")));
  const Trajectory yaw(0, timeline.curves[0].keys);
  for (const double time : {0.5, 1.0, 1.9, 2.0}) EXPECT_NEAR(yaw.at(time), 90 * kDegree, 1e-9);
  EXPECT_NEAR(yaw.at(3), 0, 1e-9);
}

TEST(Xar, ABoxOnAStopInputDoesNotPlay) {
  const std::string stop_link =
      "<Link inputowner=\"1\" indexofinput=\"3\" outputowner=\"0\" indexofoutput=\"2\"/>";
  EXPECT_EQ(errorOf(project(box("1", "fps=\"25\"", curve("HeadYaw", kYawTo90)) + stop_link)),
            "test.xar:2: no timeline here moves a joint of this robot");
}

TEST(Xar, DiagramsOnATimelineStartAtTheirFrame) {
  const std::string inner = box("1", "fps=\"25\" start_frame=\"1\"", curve("HeadYaw", kYawTo90));
  const std::string outer =
      "<Box name=\"outer\" id=\"1\"><Timeline enable=\"1\" fps=\"10\" start_frame=\"1\">"
      "<BehaviorLayer><BehaviorKeyframe index=\"21\"><Diagram>" +
      inner + link("0", "1") + "</Diagram></BehaviorKeyframe></BehaviorLayer><ActuatorList>" +
      curve("HeadPitch", "<Key frame=\"11\" value=\"1\"/>") + "</ActuatorList></Timeline></Box>";
  const Timeline timeline = read(project(outer + link("0", "1")));
  ASSERT_EQ(timeline.curves.size(), 2u);
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 1, kExact);
  EXPECT_NEAR(timeline.curves[1].keys[0].time, 3, kExact);
}

TEST(Xar, VersionOneWritesElementsInsteadOfAttributes) {
  const Timeline timeline = read(
      "<ChoregrapheProject xar_version=\"1\"><Box><name>root</name><id>-1</id><Timeline>"
      "<fps>10</fps><enable>1</enable><start_frame>0</start_frame><end_frame>-1</end_frame>"
      "<ActuatorList><ActuatorCurve><name>value</name><actuator>HeadYaw</actuator><CurveKeys><Key>"
      "<frame>10</frame><value>45</value><Tangents><Tangent><side>left</side>"
      "<interpType>bezier auto</interpType><abscissaParam>-1</abscissaParam>"
      "<ordinateParam>0</ordinateParam></Tangent></Tangents></Key></CurveKeys></ActuatorCurve>"
      "</ActuatorList></Timeline></Box></ChoregrapheProject>");
  ASSERT_EQ(timeline.curves.size(), 1u);
  EXPECT_NEAR(timeline.curves[0].keys[0].time, 1, kExact);
  EXPECT_NEAR(timeline.curves[0].keys[0].angle, 45 * kDegree, kExact);
}

TEST(Xar, LoopsEnd) {
  const Timeline timeline =
      read(project(box("1", "fps=\"25\" start_frame=\"1\"", curve("HeadYaw", kYawTo90)) +
                   link("0", "1") + link("1", "1")));
  EXPECT_NEAR(timeline.length, 1, kExact);
}

TEST(Xar, KnowsWhetherABoxHasCode) {
  const std::string motion = box("1", "fps=\"25\"", curve("HeadYaw", kYawTo90));
  EXPECT_FALSE(hasCode(project(motion), "test.xar"));
  EXPECT_FALSE(
      hasCode(project("<Box id=\"2\"><script><content> \n</content></script></Box>"), "a"));
  EXPECT_TRUE(hasCode(project(motion + "<Box id=\"2\"><script><content>say()</content></script>"
                                       "</Box>"),
                      "test.xar"));
}

TEST(Xar, ScriptsAreLeftOutAndSaidSo) {
  const std::string script =
      "<Box name=\"Say\" id=\"9\"><script language=\"4\"><content><![CDATA[say('hi')]]></content>"
      "</script></Box>";
  const Timeline timeline =
      read(project(script + box("1", "fps=\"25\" start_frame=\"1\"", curve("HeadYaw", kYawTo90)) +
                   link("0", "9") + link("9", "1")));
  EXPECT_NEAR(timeline.length, 1, kExact);
  ASSERT_EQ(timeline.warnings.size(), 1u);
  EXPECT_EQ(timeline.warnings[0], "test.xar:2: the script of the box \"Say\" is not run");
}

TEST(Xar, SaysWhereAMistakeIs) {
  EXPECT_EQ(errorOf("<ChoregrapheProject><Box></ChoregrapheProject>"),
            "test.xar:1: no well-formed XML: <Box> is not closed");
  EXPECT_EQ(errorOf("<Behavior/>"),
            "test.xar:1: expected a <ChoregrapheProject>, the root of a behavior");
  EXPECT_EQ(errorOf(project("\n" + box("1", "fps=\"0\"", curve("HeadYaw", kYawTo90)))),
            "test.xar:3: fps must be positive");
  EXPECT_EQ(errorOf(project(box("1", "", curve("HeadYaw", "\n<Key frame=\"1\" value=\"much\"/>")))),
            "test.xar:3: value must be a number, not \"much\"");
  EXPECT_EQ(errorOf(project(box("1", "", curve("HeadYaw", "<Key frame=\"1\"/>")))),
            "test.xar:2: Key lacks its value");
}

// What a timeline of 10 frames a second still plays of these curves, and what was broken.
Timeline rest(const std::string& curves) {
  return read(project("\n" + box("1", "fps=\"10\" start_frame=\"0\"", curves)));
}

TEST(Xar, AKeyThatCanNotBeReadIsLeftOutAndTheOthersArePlayed) {
  const Timeline timeline =
      rest(curve("HeadYaw",
                 "<Key frame=\"10\" value=\"5\"/>\n<Key frame=\"20\" value=\"much\"/>\n"
                 "<Key value=\"7\"/><Key frame=\"30\" value=\"9\"/>"));
  const auto& keys = timeline.curves.at(0).keys;
  ASSERT_EQ(keys.size(), 2u);
  EXPECT_NEAR(keys[1].time, 3, kExact);
  EXPECT_NEAR(keys[1].angle, 9 * kDegree, kExact);
  EXPECT_EQ(timeline.broken,
            (std::vector<std::string>{"test.xar:4: value must be a number, not \"much\"",
                                      "test.xar:5: Key lacks its frame"}));
}

TEST(Xar, ACurveOfAnUnknownUnitIsLeftOutAndTheOthersArePlayed) {
  const Timeline timeline =
      rest(curve("HeadYaw", kYawTo90, "unit=\"7\"") + curve("HeadPitch", kYawTo90));
  ASSERT_EQ(timeline.curves.size(), 1u);
  EXPECT_EQ(timeline.curves[0].joint, *makeTestRobot()->findJoint("HeadPitch"));
  ASSERT_EQ(timeline.broken.size(), 1u);
  EXPECT_EQ(timeline.broken[0].rfind("test.xar:3: unknown unit \"7\"", 0), 0u);
}

TEST(Xar, ATimelineWithoutATimeIsLeftOutAndTheOthersArePlayed) {
  const Timeline timeline =
      read(project(box("1", "fps=\"-1\"", curve("HeadYaw", kYawTo90)) +
                   box("2", "fps=\"25\" start_frame=\"1\"", curve("HeadPitch", kYawTo90)) +
                   link("0", "1") + link("1", "2")));
  EXPECT_EQ(timeline.curves.size(), 1u);
  EXPECT_EQ(timeline.broken, std::vector<std::string>{"test.xar:2: fps must be positive"});
}

TEST(Xar, CurvesOfDifferentLengthEndEachWithItsOwnLastKey) {
  const Timeline timeline =
      rest(curve("HeadYaw", "<Key frame=\"10\" value=\"5\"/>") +
           curve("HeadPitch", "<Key frame=\"10\" value=\"5\"/><Key frame=\"40\" value=\"1\"/>"));
  EXPECT_NEAR(timeline.length, 4, kExact);
  EXPECT_EQ(timeline.curves.at(0).keys.size(), 1u);
  EXPECT_NEAR(Trajectory(0, timeline.curves[0].keys).at(4), 5 * kDegree, kExact);
  EXPECT_TRUE(timeline.broken.empty());
}

TEST(Xar, BrokenXmlIsToldWithItsLineAndTheRestIsPlayed) {
  const std::string whole =
      project("\n" + box("1", "fps=\"10\" start_frame=\"0\"",
                         curve("HeadYaw",
                               "<Key frame=\"10\" value=\"5\"/>\n"
                               "<Key frame=\"20\" value=6/>\n<Key frame=\"30\" value=\"7\"/>")));
  const Timeline timeline = read(whole);
  EXPECT_EQ(timeline.curves.at(0).keys.size(), 2u);
  EXPECT_NEAR(timeline.length, 3, kExact);
  EXPECT_EQ(timeline.broken,
            std::vector<std::string>{"test.xar:4: no well-formed XML: the tag <Key is not "
                                     "well-formed; it is left out"});
}

// A text that was cut has lost the links of its diagram, which stand behind the boxes.
TEST(Xar, ACutBehaviorPlaysTheBoxesItHasOneAfterTheOther) {
  const std::string clock = "fps=\"10\" start_frame=\"0\"";
  const std::string key = "<Key frame=\"10\" value=\"5\"/>";
  const std::string whole =
      project(box("1", clock, curve("HeadYaw", key)) + box("2", clock, curve("HeadPitch", key)) +
              box("3", clock, curve("LHipRoll", key) + curve("LHipPitch", key)) + link("0", "3"));
  const Timeline timeline =
      read(whole.substr(0, whole.find("<ActuatorCurve actuator=\"LHipPitch") + 20));
  ASSERT_EQ(timeline.curves.size(), 3u);
  EXPECT_NEAR(timeline.length, 3, kExact);
  EXPECT_EQ(timeline.broken.back(),
            "test.xar:2: the links between these boxes are lost; they are played in the order of "
            "the text");
}

TEST(Xar, WhatABoxWouldHaveToChooseIsAnError) {
  const std::string chooser = "<Box name=\"Switch Case\" id=\"5\" plugin=\"dispatcher_plugin\"/>";
  EXPECT_EQ(errorOf(project(chooser + box("1", "fps=\"25\"", curve("HeadYaw", kYawTo90)) +
                            link("0", "5") + link("5", "1"))),
            "test.xar:2: nothing starts by itself: the box \"Switch Case\" would have to choose "
            "what to play");
}

struct RealFile {
  const char* path;
  double length;  // [s] as the shared manifest says, from the last key
};

// Behaviors of others, in the project's shared material only.
TEST(Xar, ReadsBehaviorsOfOthers) {
  const std::string motions = NAO_SOURCE_DIR "/../shared/motions/";
  if (!std::filesystem::exists(motions)) GTEST_SKIP() << "no " << motions << " here";
  const RealFile files[] = {
      {"kouretes+Monas/KickForwardLeftStrong.xar", 4.73},
      {"kouretes+Monas/KickBackLeftHigh.xar", 5.8},
      {"kouretes+Monas/PoseInitial.xar", 1.5},
      {"mxochicale+nao/SixUpperArmMovements__behavior_1__behavior.xar", 15.6},
      {"mxochicale+nao/macarena_naoqi21413__macarena__behavior.xar", 17.28},
  };
  for (const RealFile& wanted : files) {
    std::ifstream file(motions + wanted.path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const Timeline timeline = readXar(text, wanted.path, *makeTestRobot());
    EXPECT_NEAR(timeline.length, wanted.length, 0.21) << wanted.path;  // a start frame of 1 or 2
    EXPECT_GE(timeline.curves.size(), 10u) << wanted.path;
    for (const Curve& curve : timeline.curves) {
      double before = 0;
      for (const Key& key : curve.keys) {
        EXPECT_GT(key.time, before) << wanted.path;
        before = key.time;
      }
    }
  }
}

}  // namespace
}  // namespace nao::motion
