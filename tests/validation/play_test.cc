#include "validation/play.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "validation/play_report.h"

namespace nao::validation {
namespace {

using Kind = motion::MotionFault::Kind;

PlaySettings settingsFor(const char* robot) {
  PlaySettings settings;
  settings.model = loadRobotModel(NAO_SOURCE_DIR "/robots", robot);
  settings.world = std::make_shared<WorldModel>();
  return settings;
}

// Each of these joints moves on a straight line to an angle [rad] within `time` [s].
motion::Timeline moveTo(const RobotModel& model, double time,
                        const std::vector<std::pair<const char*, double>>& targets) {
  motion::TimelineBuilder builder;
  for (const auto& [name, angle] : targets) {
    motion::Key key;
    key.time = time;
    key.angle = angle;
    key.before.kind = key.after.kind = motion::Handle::Kind::Linear;
    builder.add(0, {*model.findJoint(name), {key}});
  }
  return builder.take();
}

bool has(const Played& played, Kind kind) {
  return std::any_of(played.faults.begin(), played.faults.end(),
                     [kind](const auto& fault) { return fault.kind == kind; });
}

TEST(Play, AQuietMotionTakesItsTimeAndHasNoFaults) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  const auto timeline = moveTo(*settings.model, 1.5, {{"HeadYaw", 0.5}});
  const Played played = play(timeline, settings);
  EXPECT_TRUE(played.done);
  EXPECT_TRUE(played.upright);
  EXPECT_NEAR(played.duration, 1.5, 1e-9);
  EXPECT_TRUE(played.faults.empty()) << played.faults.front().text;
  const auto yaw = index(*settings.model->findJoint("HeadYaw"));
  EXPECT_NEAR(played.tracks.asked[yaw].back(), 0.5, 1e-12);
  EXPECT_NEAR(played.tracks.sensed[yaw].back(), 0.5, 0.02);
}

TEST(Play, ARobotThatTipsOverFell) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  const auto timeline = moveTo(*settings.model, 1, {{"LAnklePitch", 0.5}, {"RAnklePitch", 0.5}});
  const Played played = play(timeline, settings);
  EXPECT_TRUE(played.fell);
  EXPECT_FALSE(played.upright);
  EXPECT_EQ(std::count_if(played.faults.begin(), played.faults.end(),
                          [](const auto& fault) { return fault.kind == Kind::Fall; }),
            1);
}

TEST(Play, AMotorThatIsAskedForTooMuchIsToldByName) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  const auto timeline = moveTo(*settings.model, 0.02, {{"LShoulderPitch", -1.0}});
  const Played played = play(timeline, settings);
  const auto torque = std::find_if(played.faults.begin(), played.faults.end(),
                                   [](const auto& fault) { return fault.kind == Kind::Torque; });
  ASSERT_NE(torque, played.faults.end());
  EXPECT_EQ(torque->joint, settings.model->findJoint("LShoulderPitch"));
  EXPECT_TRUE(has(played, Kind::Velocity));
}

TEST(Play, ARobotThatPushesItselfIsToldWithBothBodies) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  // Both hands meet before the chest.
  const auto timeline = moveTo(*settings.model, 2,
                               {{"LShoulderPitch", 0.7},
                                {"RShoulderPitch", 0.7},
                                {"LShoulderRoll", -0.3},
                                {"RShoulderRoll", 0.3},
                                {"LElbowYaw", -0.5},
                                {"RElbowYaw", 0.5},
                                {"LElbowRoll", -1.2},
                                {"RElbowRoll", 1.2}});
  const Played played = play(timeline, settings);
  const auto touch = std::find_if(played.faults.begin(), played.faults.end(),
                                  [](const auto& fault) { return fault.kind == Kind::Collision; });
  ASSERT_NE(touch, played.faults.end());
  EXPECT_NE(touch->text.find(" and "), std::string::npos);
  EXPECT_GT(touch->value, 0.5);
}

TEST(Play, WhatIsBrokenInTheFileIsAFault) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  auto timeline = moveTo(*settings.model, 0.5, {{"HeadYaw", 0.1}});
  timeline.broken = {"a.xar:7: no well-formed XML"};
  const Played played = play(timeline, settings);
  ASSERT_EQ(played.faults.size(), 1u);
  EXPECT_EQ(played.faults[0].kind, Kind::File);
  EXPECT_EQ(played.faults[0].text, "a.xar:7: no well-formed XML");
  const std::string text = toText(reportPlay("a.xar", timeline, settings, played));
  EXPECT_NE(text.find("its file is broken and this is the rest of it"), std::string::npos) << text;
}

TEST(Play, StartsInTheMotionsOwnFirstPoseWhenAsked) {
  PlaySettings settings = settingsFor("nao_h21_v33");
  settings.from = "first";
  const auto timeline = moveTo(*settings.model, 0.02, {{"LShoulderPitch", 0.2}});
  const Played played = play(timeline, settings);
  EXPECT_FALSE(has(played, Kind::Velocity));
  EXPECT_FALSE(has(played, Kind::Torque));
}

TEST(Play, TheShippedSitEndsOnTheSeatAndNotOnTheBack) {
  PlaySettings settings = settingsFor("nao_h21_v33");
  const auto timeline = motion::loadMotion(NAO_SOURCE_DIR "/motions/sit.xar", *settings.model);
  for (const std::uint64_t seed : {0, 1, 2, 3}) {
    settings.seed = seed;
    const Played played = play(timeline, settings);
    EXPECT_FALSE(played.fell) << seed;
    EXPECT_LT(played.tracks.height.back(), 0.14) << seed;  // [m] of a torso on the seat
    EXPECT_LT(played.tracks.tilt.back(), 0.3) << seed;
  }
}

TEST(Play, StartsOnItsBackOrBellyWhenAsked) {
  PlaySettings settings = settingsFor("nao_h21_v33");
  for (const char* posture : {"LyingBack", "LyingBelly"}) {
    settings.from = posture;
    const Played played = play(moveTo(*settings.model, 0.5, {{"HeadYaw", 0.3}}), settings);
    EXPECT_GT(played.tracks.tilt.front(), 70 * M_PI / 180) << posture;
    EXPECT_LT(played.tracks.height.front(), 0.12) << posture;
    EXPECT_FALSE(played.fell) << posture;  // it lay from the beginning on
    const auto shoulder = index(*settings.model->findJoint("LShoulderPitch"));
    EXPECT_NEAR(played.tracks.sensed[shoulder].front(),
                settings.model->findPosture(posture)->angle[shoulder], 0.1)
        << posture;
  }
}

TEST(Play, APoseTheRobotDoesNotHaveIsRefusedWithThoseItHas) {
  PlaySettings settings = settingsFor("nao_h21_v33");
  settings.from = "Handstand";
  try {
    play(moveTo(*settings.model, 1, {{"HeadYaw", 0}}), settings);
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("StandInit"), std::string::npos);
  }
}

TEST(Play, TheSameSeedGivesTheSameRunToTheLastBit) {
  PlaySettings settings = settingsFor("nao_h21_v33");
  settings.seed = 7;
  const auto timeline = moveTo(*settings.model, 0.5, {{"HeadYaw", 0.5}});
  const std::uint64_t hash = play(timeline, settings).hash;
  EXPECT_EQ(play(timeline, settings).hash, hash);
  settings.seed = 8;
  EXPECT_NE(play(timeline, settings).hash, hash);
}

TEST(PlayReport, NamesEveryFaultWithFrameAndJoint) {
  const PlaySettings settings = settingsFor("nao_h21_v33");
  const auto timeline = moveTo(*settings.model, 1, {{"HeadYaw", 2.5}});
  const Played played = play(timeline, settings);
  const std::string json = toJson(reportPlay("a.xar", timeline, settings, played));
  EXPECT_NE(json.find("\"joint_limit_faults\":1.0"), std::string::npos) << json;
  EXPECT_NE(json.find("\"kind\":\"joint_limit\",\"joint\":\"HeadYaw\""), std::string::npos);
  EXPECT_NE(json.find("\"frame\":"), std::string::npos);
}

}  // namespace
}  // namespace nao::validation
