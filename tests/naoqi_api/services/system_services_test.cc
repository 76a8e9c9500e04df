#include "naoqi_api/services/system_services.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using SystemServices = ServicesBench;

// What ros-naoqi's drivers ask before they publish anything.
TEST_F(SystemServices, AnswerWhatARosDriverAsksAtItsStart) {
  EXPECT_EQ(data("RobotConfig/Body/Type"), Value("Nao"));
  EXPECT_EQ(data("RobotConfig/Body/BaseVersion"), Value("V5.0"));
  EXPECT_FALSE(call("ALMotion", "getRobotConfig").findItems()->empty());
  EXPECT_EQ(call("ALSystem", "systemVersion"), Value("2.1.4.13"));
  EXPECT_EQ(call("ALRobotModel", "getRobotType"), Value("Nao"));
  EXPECT_EQ(call("ALRobotModel", "_getMicrophoneConfig"), Value(0));
  EXPECT_EQ(call("ALRobotModel", "hasLegs"), Value(true));
  const auto config =
      call("ALRobotModel", "_getConfigMap").to<std::map<std::string, std::string>>();
  EXPECT_EQ(config.count("RobotConfig/Head/Device/Micro/Version"), 1U);
  EXPECT_TRUE(call("ALSpeechRecognition", "_enableFreeSpeechToText").isVoid());
  EXPECT_EQ(call("ALDialog", "getLanguage"), Value("English"));
}

TEST_F(SystemServices, PreferencesAreKept) {
  call("ALPreferenceManager", "setValue", {"com.example", "volume", 7});
  EXPECT_EQ(call("ALPreferenceManager", "getValue", {"com.example", "volume"}), Value(7));
  call("ALPreferenceManager", "removeValue", {"com.example", "volume"});
  EXPECT_TRUE(call("ALPreferenceManager", "getValue", {"com.example", "volume"}).isVoid());
  EXPECT_EQ(call("ALPreferenceManager", "removeValue", {"com.example", "x"}).findText()->front(),
            '!');
}

TEST_F(SystemServices, AListenerHearsWhatIsLogged) {
  const Value object = call("LogManager", "getListener");
  const auto listener = object.find<rpc::ObjectRef>()->local;
  std::vector<std::string> heard;
  listener->signals().begin()->second.emitter.connect([&](const std::vector<Value>& arguments) {
    heard.push_back(*(*arguments.front().findItems())[4].findText());
  });
  call("ALLogger", "warn", {"walker", "the floor is wet"});
  call("ALLogger", "debug", {"walker", "step 12"});
  EXPECT_EQ(heard, std::vector<std::string>{"the floor is wet"});
}

TEST_F(SystemServices, ALauncherKnowsTheModulesAndLaunchesNone) {
  EXPECT_EQ(call("ALLauncher", "isModulePresent", {"ALMotion"}), Value(true));
  EXPECT_EQ(call("ALLauncher", "isModulePresent", {"ALCoffee"}), Value(false));
  const Value refused = call("ALLauncher", "launchExecutable", {"/bin/sh"});
  EXPECT_NE(refused.findText()->find("not simulated"), std::string::npos);
}

TEST_F(SystemServices, WhatFindsNoRoomIsRefusedNotDropped) {
  for (int i = 0; i < 255; ++i) {
    call("ALAudioDevice", "setParameter", {"p" + std::to_string(i), 1});
    call("ALAudioDevice", "subscribeRemoteModule", {"m" + std::to_string(i)});
  }
  const Value refused = call("ALAudioDevice", "setParameter", {"one more", 1});
  EXPECT_NE(refused.findText()->find("there is no room for one more"), std::string::npos);
  call("ALAudioDevice", "setParameter", {"outputSampleRate", 48000});
  EXPECT_EQ(call("ALAudioDevice", "getParameter", {"outputSampleRate"}), Value(48000));
  EXPECT_EQ(call("ALAudioDevice", "subscribeRemoteModule", {"last"}), Value(true));
  EXPECT_EQ(call("ALAudioDevice", "subscribeRemoteModule", {"last"}), Value(true));
  EXPECT_EQ(call("ALAudioDevice", "subscribeRemoteModule", {"more"}).findText()->front(), '!');
}

TEST_F(SystemServices, TheOldPoseServiceTellsHowTheRobotStands) {
  const Value pose = call("ALRobotPose", "getActualPoseAndTime");
  EXPECT_EQ(pose.findItems()->size(), 2U);
  const auto names = call("ALRobotPose", "getPoseNames").to<std::vector<std::string>>();
  EXPECT_NE(std::find(names.begin(), names.end(), *(*pose.findItems())[0].findText()), names.end());
}

}  // namespace
}  // namespace nao::services
