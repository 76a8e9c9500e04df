// A module that hears, and a client that makes the sound which robots here do not.

#include <alaudio/alsoundextractor.h>
#include <alcommon/albroker.h>
#include <alcommon/altoolsmain.h>
#include <gtest/gtest.h>
#include <rttools/rttime.h>

#include <csignal>
#include <functional>
#include <qi/application.hpp>
#include <string>
#include <vector>

#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

using AL::ALValue;

class Ear : public AL::ALSoundExtractor {
 public:
  Ear(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALSoundExtractor(broker, name) {}

  void init() override {
    audioDevice->callVoid("setClientPreferences", getName(), 48000, (int)AL::ALLCHANNELS, 1);
    startDetection();
  }

  void process(const int& channels, const int& samples, const AL_SOUND_FORMAT* buffer,
               const ALValue& time_stamp) override {
    heard.assign(buffer, buffer + channels * samples);
    time = time_stamp;
  }

  bool listens() const { return fIsRunning; }

  std::vector<AL_SOUND_FORMAT> heard;
  ALValue time;
};

class OldEar : public AL::ALSoundExtractor {
 public:
  OldEar(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALSoundExtractor(broker, name) {}
  void processSound(const int channels, const int samples, const AL_SOUND_FORMAT* buffer) override {
    heard.assign(buffer, buffer + channels * samples);
  }
  std::vector<AL_SOUND_FORMAT> heard;
};

class SoundExtractorTest : public testing::Test {
 protected:
  SoundExtractorTest()
      : broker_(AL::ALBroker::createBroker("broker", "0.0.0.0", 0, "127.0.0.1", robot_.port())) {}
  ~SoundExtractorTest() override { broker_->shutdown(); }

  ALValue sound() const {
    return ALValue(samples_.data(), static_cast<int>(samples_.size() * sizeof samples_[0]));
  }

  RobotProcess robot_;
  boost::shared_ptr<AL::ALBroker> broker_;
  const std::vector<AL_SOUND_FORMAT> samples_{1, -2, 32767, -32768};
};

TEST_F(SoundExtractorTest, SubscribesAndLeaves) {
  const auto ear = AL::ALModule::createModule<Ear>(broker_, "Ear");
  EXPECT_TRUE(ear->listens());
  ear->startDetection();
  ear->stopDetection();
  EXPECT_FALSE(ear->listens());
}

TEST_F(SoundExtractorTest, HearsWhatIsSentToIt) {
  const auto ear = AL::ALModule::createModule<Ear>(broker_, "Ear");
  AL::ALProxy(broker_, "Ear").callVoid("processRemote", 2, 2, ALValue::array(3, 4), sound());
  EXPECT_EQ(ear->heard, samples_);
  EXPECT_EQ(static_cast<int>(ear->time[1]), 4);
}

TEST_F(SoundExtractorTest, TheOldNameIsCalledWhereTheNewOneIsNotWritten) {
  const auto ear = AL::ALModule::createModule<OldEar>(broker_, "OldEar");
  AL::ALProxy(broker_, "OldEar").callVoid("processSoundRemote", 1, 4, sound());
  EXPECT_EQ(ear->heard, samples_);
}

int stops = 0;

int makeEarThatIsToldToEnd(boost::shared_ptr<AL::ALBroker> broker) {
  const auto ear = AL::ALModule::createModule<Ear>(broker, "Ear");
  qi::Application::atStop(std::bind(&AL::ALSoundExtractor::stopDetection, ear.get()));
  qi::Application::atStop([ear] { stops += ear->listens() ? 100 : 1; });
  ::raise(SIGTERM);
  return 0;
}

TEST_F(SoundExtractorTest, WhatIsLeftForTheEndIsDoneThere) {
  std::string port = "--pport=" + std::to_string(robot_.port());
  std::string name = "ear";
  char* words[] = {name.data(), port.data(), nullptr};
  EXPECT_EQ(ALTools::mainFunction("ear", 2, words, makeEarThatIsToldToEnd), 0);
  EXPECT_EQ(stops, 1);
}

TEST_F(SoundExtractorTest, LessThanWasSaidIsRefused) {
  const auto ear = AL::ALModule::createModule<Ear>(broker_, "Ear");
  const AL::ALProxy proxy(broker_, "Ear");
  EXPECT_THROW(proxy.callVoid("processRemote", 4, 2, ALValue(), sound()), AL::ALError);
  EXPECT_THROW(proxy.callVoid("processRemote", -1, 2, ALValue(), sound()), AL::ALError);
  EXPECT_THROW(proxy.callVoid("processRemote", 1, 1, ALValue(), ALValue("text")), AL::ALError);
  EXPECT_TRUE(ear->heard.empty());
}

}  // namespace
}  // namespace nao
