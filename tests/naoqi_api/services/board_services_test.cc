#include "naoqi_api/services/board_services.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/naoqi_api/services/services_bench.h"

namespace nao::services {
namespace {

using rpc::Value;
using BoardServices = ServicesBench;

TEST_F(BoardServices, AnExtractorKnowsItsSubscribers) {
  call("ALSonar", "subscribe", {"me", 200, 0.5F});
  call("ALSonar", "subscribe", {"you"});
  EXPECT_EQ(call("ALSonar", "getMyPeriod", {"me"}), Value(200));
  EXPECT_EQ(call("ALSonar", "getCurrentPeriod"), Value(30));
  EXPECT_EQ(call("ALSonar", "getSubscribersInfo").findItems()->size(), 2U);
  call("ALSonar", "unsubscribe", {"you"});
  EXPECT_EQ(call("ALSonar", "getCurrentPeriod"), Value(200));
  EXPECT_EQ(call("ALSonar", "unsubscribe", {"you"}),
            Value("! \tALSonar::unsubscribe\n\tyou has not subscribed to ALSonar"));
}

TEST_F(BoardServices, TheSonarTellsWhatIsNearWhileSomebodySubscribes) {
  bench_.frame.sonar[0][0] = 0.3;
  bench_.frame.sonar[1][0] = 1.5;
  run(0.5);
  EXPECT_TRUE(data("SonarLeftDetected").isVoid());
  call("ALSonar", "subscribe", {"me"});
  run(0.5);
  EXPECT_FLOAT_EQ(static_cast<float>(number(data("SonarLeftDetected"))), 0.3F);
  EXPECT_FLOAT_EQ(static_cast<float>(number(data("SonarRightNothingDetected"))), 1.5F);
  EXPECT_TRUE(data("SonarRightDetected").isVoid());
}

TEST_F(BoardServices, TouchChangedTellsWhatChanged) {
  bench_.frame.touch.head[1] = true;
  run(0.1);
  EXPECT_EQ(data("TouchChanged"), Value::list({Value::list({"Head/Touch/Middle", true})}));
  bench_.frame.touch.head[1] = false;
  run(0.1);
  EXPECT_EQ(data("TouchChanged"), Value::list({Value::list({"Head/Touch/Middle", false})}));
}

// Time may go faster than clients are served: many cycles lie between two deliveries.
TEST_F(BoardServices, APressShorterThanADeliveryIsTold) {
  std::vector<std::string> heard;
  std::vector<std::shared_ptr<void>> tokens;
  for (const char* event : {"MiddleTactilTouched", "RightBumperPressed", "TouchChanged"}) {
    tokens.push_back(
        services_.memory().store().listen(event, [&heard](const auto& key, const auto& value) {
          heard.push_back(key + " " + value.print());
        }));
  }
  const auto publish = [this] {
    bench_.ports->publish(std::make_shared<const SensorFrame>(bench_.frame));
  };
  bench_.frame.touch.head[1] = true;
  publish();
  bench_.frame.touch.head[1] = false;
  publish();
  bench_.frame.feet[1].bumper[0] = true;
  publish();
  bench_.frame.feet[1].bumper[0] = false;
  publish();
  cycle();
  EXPECT_THAT(heard, testing::UnorderedElementsAre(
                         "MiddleTactilTouched 1", "MiddleTactilTouched 0", "RightBumperPressed 1",
                         "RightBumperPressed 0", "TouchChanged [[\"Head/Touch/Middle\", true]]",
                         "TouchChanged [[\"Head/Touch/Middle\", false]]",
                         "TouchChanged [[\"RFoot/Bumper/Left\", true]]",
                         "TouchChanged [[\"RFoot/Bumper/Left\", false]]"));
}

TEST_F(BoardServices, TouchesBeyondWhatIsKeptAreLostButNotWhatIsFeltAtTheEnd) {
  for (int i = 0; i < 1001; ++i) {
    bench_.frame.touch.chest_button = i % 2 == 0;
    bench_.ports->publish(std::make_shared<const SensorFrame>(bench_.frame));
  }
  cycle();
  EXPECT_EQ(number(data("ChestButtonPressed")), 1);
  EXPECT_EQ(data("TouchChanged"), Value::list({Value::list({"ChestBoard/Button", true})}));
}

TEST_F(BoardServices, ClicksOfTheChestButtonAreCountedInRows) {
  std::vector<std::string> heard;
  std::vector<std::shared_ptr<void>> tokens;
  for (const char* which : {"Simple", "Double", "Triple"}) {
    const std::string event = std::string("ALChestButton/") + which + "ClickOccurred";
    tokens.push_back(services_.memory().store().listen(
        event, [&heard, which](const auto& /*key*/, const auto& /*value*/) {
          heard.emplace_back(which);
        }));
  }
  for (const int clicks : {1, 3, 2, 4}) {
    for (int i = 0; i < clicks; ++i) {
      bench_.frame.touch.chest_button = true;
      run(0.1);
      bench_.frame.touch.chest_button = false;
      run(0.2);
    }
    run(1);
  }
  EXPECT_THAT(heard, testing::ElementsAre("Simple", "Triple", "Double"));  // four are none of them
}

TEST_F(BoardServices, TheBatteryIsTheRobots) {
  run(1.2);
  bench_.frame.battery.charge = 0.42;
  run(1.5);
  EXPECT_EQ(call("ALBattery", "getBatteryCharge"), Value(42));
  EXPECT_EQ(data("BatteryChargeChanged"), Value(42));
}

TEST_F(BoardServices, HotMotorsAreNamed) {
  EXPECT_EQ(call("ALBodyTemperature", "getTemperatureDiagnosis"), Value::list({}));
  bench_.frame.overheating[*bench_.model->findJoint("LKneePitch")] = 2;
  run(1.5);
  const Value hot = Value::list({2, Value::list({"LKneePitch"})});
  EXPECT_EQ(call("ALBodyTemperature", "getTemperatureDiagnosis"), hot);
  EXPECT_EQ(data("TemperatureDiagnosisErrorChanged"), hot);
}

TEST_F(BoardServices, WhoSeesNothingSaysSoOnceItIsAsked) {
  call("ALFaceDetection", "subscribe", {"me", 500, 0.0F});
  EXPECT_EQ(data("FaceDetected"), Value::list({}));
  EXPECT_EQ(call("ALLandMarkDetection", "isProcessing"), Value(false));
  EXPECT_EQ(call("ALFaceDetection", "isProcessing"), Value(true));
  call("ALFaceDetection", "setResolution", {2});
  EXPECT_EQ(call("ALFaceDetection", "getResolution"), Value(2));
}

TEST_F(BoardServices, WhatIsEnabledIsToldBack) {
  EXPECT_EQ(call("ALFaceDetection", "isTrackingEnabled"), Value(false));
  call("ALFaceDetection", "enableTracking", {true});
  EXPECT_EQ(call("ALFaceDetection", "isTrackingEnabled"), Value(true));
  call("ALFaceDetection", "setTrackingEnabled", {false});
  EXPECT_EQ(call("ALFaceDetection", "isTrackingEnabled"), Value(false));
  EXPECT_EQ(call("ALFaceDetection", "isRecognitionEnabled"), Value(false));
}

TEST_F(BoardServices, LifeChangesItsStateByItsRules) {
  EXPECT_EQ(call("ALAutonomousLife", "getState"), Value("disabled"));
  call("ALAutonomousLife", "setState", {"solitary"});
  EXPECT_EQ(data("AutonomousLife/State"), Value("solitary"));
  EXPECT_EQ(call("ALAutonomousLife", "setState", {"interactive"}).findText()->substr(0, 1), "!");
  EXPECT_EQ(call("ALAutonomousLife", "setState", {"asleep"}).findText()->substr(0, 1), "!");
  EXPECT_EQ(call("ALAutonomousLife", "getStateHistory").findItems()->size(), 2U);
}

TEST_F(BoardServices, ASoundTakesItsTimeAndCanBeStopped) {
  const double begin = now();
  call("ALAudioPlayer", "playFile", {"/home/nao/song.mp3"});
  EXPECT_NEAR(now() - begin, 3, 0.1);  // a file that is not there
  EXPECT_EQ(log_.back(), "plays: /home/nao/song.mp3");

  const Value id = call("ALAudioPlayer", "loadFile", {"/home/nao/song.mp3"});
  const auto playing = start("ALAudioPlayer", "playInLoop", {id});
  run(4);
  EXPECT_FALSE(playing.isDone());
  EXPECT_NEAR(number(call("ALAudioPlayer", "getCurrentPosition", {id})), 1, 0.1);
  call("ALAudioPlayer", "stopAll");
  EXPECT_TRUE(playing.isDone());
}

TEST_F(BoardServices, APlaceInASoundIsANumber) {
  const Value id = call("ALAudioPlayer", "loadFile", {"/home/nao/song.mp3"});
  const float nowhere = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(call("ALAudioPlayer", "playFileFromPosition", {"/home/nao/song.mp3", nowhere}),
            Value("! \tALAudioPlayer::playFileFromPosition\n\texpected a finite number"));
  EXPECT_EQ(call("ALAudioPlayer", "goTo", {id, nowhere}),
            Value("! \tALAudioPlayer::goTo\n\texpected a finite number"));
  EXPECT_EQ(number(call("ALAudioPlayer", "getCurrentPosition", {id})), 0);
}

TEST_F(BoardServices, AVolumeIsKeptWithinItsRangeAndIsANumber) {
  const Value id = call("ALAudioPlayer", "loadFile", {"/home/nao/song.mp3"});
  call("ALAudioPlayer", "setVolume", {id, 3.F});
  EXPECT_EQ(number(call("ALAudioPlayer", "getVolume", {id})), 1);
  const float nothing = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(call("ALAudioPlayer", "setVolume", {id, nothing}),
            Value("! \tALAudioPlayer::setVolume\n\texpected a finite number"));
  EXPECT_EQ(call("ALAudioPlayer", "setMasterVolume", {nothing}),
            Value("! \tALAudioPlayer::setMasterVolume\n\texpected a finite number"));
  EXPECT_EQ(number(call("ALAudioPlayer", "getVolume", {id})), 1);
  EXPECT_EQ(number(call("ALAudioPlayer", "getMasterVolume")), 1);
}

TEST_F(BoardServices, AnimatedSpeechSaysItsWords) {
  call("ALAnimatedSpeech", "say", {"Hello ^start(animations/Hey_1) you"});
  EXPECT_EQ(log_.back(), "says: Hello  you");
  EXPECT_EQ(data("ALAnimatedSpeech/EndOfAnimatedSpeech"), Value(1));
}

}  // namespace
}  // namespace nao::services
