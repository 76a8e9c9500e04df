// Modules of this program that a daemon and its other clients call.

#include <alcommon/albroker.h>
#include <alcommon/albrokermanager.h>
#include <alcommon/almodule.h>
#include <alcommon/alproxy.h>
#include <alproxies/almemoryproxy.h>
#include <althread/alcriticalsection.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <utility>

#include "tests/sdk_cpp/robot_process.h"

namespace nao {
namespace {

using AL::ALValue;

struct Heard {
  std::string key;
  ALValue value;
  std::string message;
};

class Listener : public AL::ALModule {
 public:
  Listener(boost::shared_ptr<AL::ALBroker> broker, const std::string& name)
      : AL::ALModule(broker, name), memory_(broker), mutex_(AL::ALMutex::createALMutex()) {
    setModuleDescription("Hears events.");
    functionName("onEvent", getName(), "Called at an event.");
    addParam("key", "Its name.");
    BIND_METHOD(Listener::onEvent)
    functionName("onTouch", getName(), "Called without arguments.");
    BIND_METHOD(Listener::onTouch);
    functionName("half", getName(), "Half of a number.");
    setReturn("half", "The half.");
    BIND_METHOD(Listener::half);
    functionName("lengths", getName(), "How long texts are.");
    BIND_METHOD(Listener::lengths);
    functionName("askMyself", getName(), "Calls one of its own methods through the robot.");
    BIND_METHOD(Listener::askMyself);
    functionName("fail", getName(), "Throws.");
    BIND_METHOD(Listener::fail);
  }
  ~Listener() override { memory_.unsubscribeToEvent("TestEvent", getName()); }

  void init() override {
    initialised = true;
    memory_.subscribeToEvent("TestEvent", getName(), "a message", "onEvent");
    memory_.subscribeToEvent("TestTouch", getName(), "onTouch");
  }

  void onEvent(const std::string& key, const ALValue& value, const std::string& message) {
    const AL::ALCriticalSection hold(mutex_);
    heard.set_value({key, value, message});
  }
  void onTouch() { touched.set_value(); }
  float half(const float& number) const { return number / 2; }
  std::vector<int> lengths(const std::vector<std::string>& texts) {
    std::vector<int> all;
    for (const std::string& text : texts) all.push_back(static_cast<int>(text.size()));
    return all;
  }
  float askMyself() { return AL::ALProxy(getParentBroker(), getName()).call<float>("half", 5.0F); }
  void fail() { throw ALERROR(getName(), "fail", "on purpose"); }

  bool initialised = false;
  std::promise<Heard> heard;
  std::promise<void> touched;

 private:
  AL::ALMemoryProxy memory_;
  boost::shared_ptr<AL::ALMutex> mutex_;
};

class ModuleTest : public testing::Test {
 protected:
  ModuleTest()
      : broker_(AL::ALBroker::createBroker("broker", "0.0.0.0", 0, "127.0.0.1", robot_.port())),
        module_(AL::ALModule::createModule<Listener>(broker_, "Listener")),
        proxy_(broker_, "Listener") {}
  ~ModuleTest() override {
    module_.reset();
    broker_->shutdown();
  }

  RobotProcess robot_;
  boost::shared_ptr<AL::ALBroker> broker_;
  boost::shared_ptr<Listener> module_;
  AL::ALProxy proxy_;
};

TEST_F(ModuleTest, IsInitialisedOnceItIsMade) { EXPECT_TRUE(module_->initialised); }

TEST_F(ModuleTest, OthersCallItsMethods) {
  EXPECT_EQ(proxy_.call<float>("half", 3), 1.5F);
  EXPECT_EQ(proxy_.call<std::vector<int>>("lengths", ALValue::array("a", "bcd")),
            (std::vector<int>{1, 3}));
}

TEST_F(ModuleTest, AnEventReachesItWithItsNameValueAndMessage) {
  AL::ALMemoryProxy(broker_).raiseEvent("TestEvent", 42.0F);
  const Heard heard = module_->heard.get_future().get();
  EXPECT_EQ(heard.key, "TestEvent");
  EXPECT_EQ(static_cast<float>(heard.value), 42.0F);
  EXPECT_EQ(heard.message, "a message");
}

TEST_F(ModuleTest, ACallbackMayTakeNoArguments) {
  AL::ALMemoryProxy(broker_).raiseEvent("TestTouch", 1.0F);
  EXPECT_EQ(module_->touched.get_future().wait_for(std::chrono::seconds(20)),
            std::future_status::ready);
}

TEST_F(ModuleTest, AMethodMayCallItsOwnModule) { EXPECT_EQ(proxy_.call<float>("askMyself"), 2.5F); }

TEST_F(ModuleTest, AnExceptionIsAnErrorReply) {
  try {
    proxy_.callVoid("fail");
    FAIL();
  } catch (const AL::ALError& error) {
    EXPECT_NE(error.toString().find("on purpose"), std::string::npos);
  }
}

TEST_F(ModuleTest, APostedMethodIsWaitedFor) {
  const int id = proxy_.pCall("half", 3.0F);
  EXPECT_FALSE(proxy_.wait(id, 0));
  EXPECT_FALSE(proxy_.isRunning(id));
}

TEST_F(ModuleTest, APostedMethodMayCallItsOwnModuleWhileItIsWaitedFor) {
  const int id = proxy_.pCall("askMyself");
  EXPECT_FALSE(proxy_.wait(id, 0));
}

TEST_F(ModuleTest, WhatIsNotBoundIsNotThere) {
  EXPECT_THROW(proxy_.callVoid("init"), AL::ALError);
  EXPECT_THROW(proxy_.callVoid("half", "text"), AL::ALError);
}

TEST_F(ModuleTest, ItsNameIsFreeAgainAfterShutdown) {
  EXPECT_THROW(AL::ALModule::createModule<Listener>(broker_, "Listener"), AL::ALError);
  module_.reset();
  broker_->shutdown();
  EXPECT_THROW(AL::ALProxy(broker_, "Listener"), AL::ALError);
  module_ = AL::ALModule::createModule<Listener>(broker_, "Listener");
  EXPECT_EQ(AL::ALProxy(broker_, "Listener").call<float>("half", 1.0F), 0.5F);
}

TEST_F(ModuleTest, TheCycleIsForLocalModulesAlone) {
  EXPECT_THROW(AL::ALProxy(broker_, "DCM").getModule()->atPostProcess([] {}), AL::ALError);
}

}  // namespace
}  // namespace nao
