#include "naoqi_api/services/al_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/models.h"

namespace nao::services {
namespace {

using rpc::Value;
using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

constexpr char kYaw[] = "Device/SubDeviceList/HeadYaw/Position/Sensor/Value";

// A module that a client hosts: keeps what it is called with.
class HostedModule : public rpc::RemoteObject {
 public:
  rpc::Pending<std::shared_ptr<rpc::Service>> offer() override {
    return rpc::Pending<std::shared_ptr<rpc::Service>>::failed("not asked in these tests");
  }
  rpc::Pending<Value> call(std::string_view name, const std::vector<Value>& arguments) override {
    rpc::Pending<Value> result;  // never ends if it fits: nobody may wait for it
    if (arguments.size() == takes) {
      calls.push_back(std::string(name) + " " + Value::list(arguments).print());
    } else {
      result.fail("no such method");
    }
    return result;
  }
  bool isReachable() const override { return reachable; }

  std::size_t takes = 3;
  std::vector<std::string> calls;
  bool reachable = true;
};

class AlMemoryTest : public ::testing::Test {
 protected:
  AlMemoryTest() {
    SensorFrame frame;
    frame.angle = frame.current = frame.temperature = JointArray<double>(model_->jointCount());
    frame.angle[*model_->findJoint("HeadYaw")] = 0.5;
    ports_->publish(std::make_shared<const SensorFrame>(frame));
    motion::MotionState state;
    state.command.angle = state.command.stiffness = frame.angle;
    ports_->state.publish(state);
  }

  // The outcome of a call: its value, or its error as a text "! ...".
  Value call(const std::string& method, const std::vector<Value>& arguments) {
    return outcomeOf(service_.call(method, arguments, {session_}));
  }
  // A call by number, as most clients do.
  Value callUid(std::uint32_t uid, const std::vector<Value>& arguments) {
    return outcomeOf(service_.findMethod(uid)->invoke({session_, &service_}, arguments));
  }
  static Value outcomeOf(const rpc::Pending<Value>& result) {
    if (!result.isDone()) return "! still running";
    const auto& outcome = *result.outcome();
    return outcome.error ? Value("! " + *outcome.error) : *outcome.value;
  }
  std::vector<std::string> names(const std::string& method, const std::vector<Value>& arguments) {
    return call(method, arguments).to<std::vector<std::string>>();
  }

  std::shared_ptr<rpc::Service> subscribe(const std::string& event) {
    const Value object = call("subscriber", {event});
    const auto* reference = object.find<rpc::ObjectRef>();
    return reference ? reference->local : nullptr;
  }
  // Connects as the wire does when a client registers for the object's signal.
  void listen(const rpc::Service& object) {
    const rpc::Emitter* signal = object.findSignal(rpc::Service::kFirstUid);
    ASSERT_NE(signal, nullptr);
    EXPECT_EQ(signal->signature(), "(m)");
    signal->connect([this](const std::vector<Value>& arguments) {
      heard_.push_back(arguments.front().print());
    });
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  std::shared_ptr<motion::RobotPorts> ports_ = std::make_shared<motion::RobotPorts>();
  Duration now_ = seconds(1'300'000'000);
  memory::RobotMemory memory_{*model_, ports_, "nao", [this] { return now_; }};
  std::map<std::string, std::shared_ptr<HostedModule>> modules_;
  AlMemory al_memory_{memory_, [this](const std::string& name) { return modules_[name]; }};
  rpc::Service service_ = al_memory_.describe();
  std::shared_ptr<rpc::Session> session_ =
      std::make_shared<rpc::Session>(7, "tcp://127.0.0.1:9559");
  std::vector<std::string> heard_;
};

TEST_F(AlMemoryTest, ReadsDevicesInBothForms) {
  EXPECT_EQ(call("getData", {kYaw}), Value(0.5F));
  EXPECT_EQ(call("getData", {kYaw, 0}), Value(0.5F));
}

TEST_F(AlMemoryTest, AMissingKeyGivesTheKnownErrorText) {
  EXPECT_EQ(call("getData", {"Nope"}), Value("! \tALMemory::getData\n\tData not found Nope"));
  EXPECT_EQ(call("getData", {"Nope", 0}), Value("! \tALMemory::getData\n\tData not found Nope"));
  EXPECT_EQ(call("getTimestamp", {"Nope"}),
            Value("! \tALMemory::getTimestamp\n\tData not found Nope"));
}

TEST_F(AlMemoryTest, KeepsWhatIsInsertedWithItsType) {
  callUid(130, {"int", 5});
  callUid(131, {"float", 2.5F});
  callUid(132, {"text", "five"});
  callUid(133, {"list", Value::list({1, "two", Value::list({3.5})})});
  EXPECT_EQ(call("getData", {"int"}), Value(5));
  EXPECT_EQ(call("getData", {"float"}), Value(2.5F));
  EXPECT_EQ(call("getData", {"text"}), Value("five"));
  EXPECT_EQ(call("getData", {"list"}), Value::list({1, "two", Value::list({3.5})}));
}

TEST_F(AlMemoryTest, InsertsAListOfPairsOrNothing) {
  const Value pairs = Value::list({Value::list({"a", 1}), Value::tuple({"b", "two"})});
  EXPECT_TRUE(call("insertListData", {pairs}).isVoid());
  EXPECT_EQ(call("getListData", {Value::list({"a", "b"})}), Value::list({1, "two"}));
  const Value broken = Value::list({Value::list({"c", 1}), Value::list({"d"})});
  EXPECT_EQ(call("insertListData", {broken}),
            Value("! \tALMemory::insertListData\n\texpected [key, value], got [\"d\"]"));
  EXPECT_EQ(call("getListData", {Value::list({"c"})}), Value::list({Value()}));
}

TEST_F(AlMemoryTest, ReadsListsWithNothingForMissingKeys) {
  callUid(130, {"a", 1});
  EXPECT_EQ(call("getListData", {Value::list({"a", "Nope", kYaw})}),
            Value::list({1, Value(), 0.5F}));
  EXPECT_EQ(call("getListData", {"a"}), Value::list({1}));
}

TEST_F(AlMemoryTest, WhatADeviceMeasuresCanNotBeOverwritten) {
  EXPECT_TRUE(callUid(131, {kYaw, 9.0F}).isVoid());
  EXPECT_EQ(call("getData", {kYaw}), Value(0.5F));
}

TEST_F(AlMemoryTest, AnIdleDeviceTakesAnotherValue) {
  const std::string mode = "Device/SubDeviceList/US/Actuator/Value";
  EXPECT_EQ(call("getData", {mode}), Value(0.0F));
  callUid(131, {mode, 4.0F});
  EXPECT_EQ(call("getData", {mode}), Value(4.0F));
}

// As joints do not move for it: devices write over what others put there.
TEST_F(AlMemoryTest, StoringAValueLightsNothing) {
  const std::string led = "Device/SubDeviceList/ChestBoard/Led/Red/Actuator/Value";
  EXPECT_EQ(call("getData", {led}), Value(0.0F));
  callUid(131, {led, 1.0F});
  EXPECT_EQ(call("getData", {led}), Value(0.0F));
}

TEST_F(AlMemoryTest, TellsWhenAKeyWasWritten) {
  now_ = seconds(1'300'000'001) + milliseconds(250);
  callUid(130, {"a", 1});
  now_ += seconds(5);
  EXPECT_EQ(call("getTimestamp", {"a"}), Value::list({1, 1'300'000'001, 250'000}));
  EXPECT_EQ(call("getTimestamp", {kYaw}), Value::list({0.5F, 1'300'000'006, 250'000}));
}

TEST_F(AlMemoryTest, RemembersTheHistoryOfEventsOnly) {
  call("raiseEvent", {"event", 1});
  now_ += milliseconds(10);
  call("raiseEvent", {"event", 2});
  call("raiseMicroEvent", {"micro", 1});
  EXPECT_EQ(call("getEventHistory", {"event"}),
            Value::list({Value::list({1, Value::list({1'300'000'000, 0})}),
                         Value::list({2, Value::list({1'300'000'000, 10'000})})}));
  EXPECT_EQ(call("getEventHistory", {"micro"}), Value::list({}));
  EXPECT_EQ(call("getEventHistory", {"Nope"}),
            Value("! \tALMemory::getEventHistory\n\tData not found Nope"));
}

TEST_F(AlMemoryTest, ListsKeysByTextAndByType) {
  callUid(130, {"my/data", 1});
  call("raiseEvent", {"my/event", 1});
  call("raiseMicroEvent", {"my/micro", 1});
  call("declareEvent", {"my/declared"});
  EXPECT_THAT(names("getDataList", {"my/"}),
              ElementsAre("my/data", "my/declared", "my/event", "my/micro"));
  EXPECT_THAT(names("getDataListName", {}), IsSupersetOf({"my/data", "my/event", kYaw}));
  EXPECT_THAT(names("getEventList", {}),
              AllOf(IsSupersetOf({"my/event", "my/declared"}), Not(Contains("my/micro")),
                    Not(Contains("my/data"))));
  EXPECT_THAT(names("getMicroEventList", {}), ElementsAre("my/micro"));
  EXPECT_EQ(call("getType", {"my/data"}), Value("Data"));
  EXPECT_EQ(call("getType", {"my/event"}), Value("Event"));
  EXPECT_EQ(call("getType", {"my/micro"}), Value("MicroEvent"));
  EXPECT_EQ(call("getType", {kYaw}), Value("Data"));
}

TEST_F(AlMemoryTest, AKeyBothWrittenAndMeasuredIsListedOnce) {
  callUid(131, {kYaw, 9.0F});
  EXPECT_THAT(names("getDataList", {kYaw}), ElementsAre(kYaw));
}

TEST_F(AlMemoryTest, KnowsDescriptionsAndExtractors) {
  call("declareEvent", {"ball", "ALRedBallDetection"});
  call("setDescription", {"ball", "where the ball is"});
  const Value expected = Value::list({Value::list({"ball", "event", "where the ball is"})});
  EXPECT_EQ(call("getDescriptionList", {Value::listOf("s", {"ball"})}), expected);
  EXPECT_EQ(call("getDescriptionList", {Value::listOf("s", {})}), expected);
  EXPECT_THAT(names("getExtractorEvent", {"ALRedBallDetection"}), ElementsAre("ball"));
  EXPECT_EQ(call("setDescription", {"Nope", ""}),
            Value("! \tALMemory::setDescription\n\tData not found Nope"));
}

TEST_F(AlMemoryTest, ASubscriberHearsEveryRaiseBeforeTheRaisingCallEnds) {
  const auto object = subscribe("ball");
  ASSERT_NE(object, nullptr);
  listen(*object);
  const auto raised = service_.call("raiseEvent", {"ball", Value::list({1, 2})}, {session_});
  EXPECT_TRUE(raised.isDone());
  raised.whenDone([this](const auto& /*outcome*/) { heard_.push_back("reply"); });
  call("raiseMicroEvent", {"ball", "same"});
  call("raiseMicroEvent", {"ball", "same"});
  EXPECT_THAT(heard_, ElementsAre("[1, 2]", "reply", "\"same\"", "\"same\""));
}

TEST_F(AlMemoryTest, InsertingTellsNoSubscriber) {
  const auto object = subscribe("ball");
  listen(*object);
  callUid(130, {"ball", 1});
  EXPECT_THAT(heard_, IsEmpty());
}

TEST_F(AlMemoryTest, ASubscriberThatIsDroppedLeavesNothingBehind) {
  const std::size_t keys = memory_.store().entries().size();
  auto object = subscribe("ball");
  listen(*object);
  EXPECT_EQ(memory_.store().listenerCount("ball"), 1U);
  object.reset();
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
  EXPECT_EQ(memory_.store().entries().size(), keys);
  call("raiseEvent", {"ball", 1});
  EXPECT_THAT(heard_, IsEmpty());
}

TEST_F(AlMemoryTest, CallsBackAModuleWithEventValueAndMessage) {
  const auto module = modules_["Mine"] = std::make_shared<HostedModule>();
  call("subscribeToEvent", {"ball", "Mine", "onBall"});
  call("subscribeToMicroEvent", {"micro", "Mine", "hello", "onMicro"});
  EXPECT_THAT(names("getSubscribers", {"ball"}), ElementsAre("Mine"));
  call("raiseEvent", {"ball", 1});
  call("raiseMicroEvent", {"micro", 2});
  EXPECT_THAT(module->calls,
              ElementsAre("onBall [\"ball\", 1, \"\"]", "onMicro [\"micro\", 2, \"hello\"]"));
}

TEST_F(AlMemoryTest, ACallbackMayTakeFewerArguments) {
  const auto two = modules_["Two"] = std::make_shared<HostedModule>();
  const auto none = modules_["None"] = std::make_shared<HostedModule>();
  const auto odd = modules_["Odd"] = std::make_shared<HostedModule>();
  two->takes = 2;
  none->takes = 0;
  odd->takes = 5;
  for (const char* module : {"Two", "None", "Odd"}) {
    call("subscribeToEvent", {"ball", module, "onBall"});
  }
  call("raiseEvent", {"ball", 1});
  EXPECT_THAT(two->calls, ElementsAre("onBall [\"ball\", 1]"));
  EXPECT_THAT(none->calls, ElementsAre("onBall []"));
  EXPECT_THAT(odd->calls, IsEmpty());
}

TEST_F(AlMemoryTest, TouchSensorsAreEventsThatNothingPressed) {
  EXPECT_EQ(call("getData", {"FrontTactilTouched"}), Value(0.0F));
  EXPECT_EQ(call("getType", {"FrontTactilTouched"}), Value("Event"));
  EXPECT_EQ(call("getData", {"HandLeftBackTouched"}),
            Value("! \tALMemory::getData\n\tData not found HandLeftBackTouched"));
}

TEST_F(AlMemoryTest, AModuleHasOneCallbackPerEventUntilItUnsubscribes) {
  const auto module = modules_["Mine"] = std::make_shared<HostedModule>();
  call("subscribeToEvent", {"ball", "Mine", "first"});
  call("subscribeToEvent", {"ball", "Mine", "second"});
  call("raiseEvent", {"ball", 1});
  EXPECT_THAT(module->calls, ElementsAre("second [\"ball\", 1, \"\"]"));
  EXPECT_TRUE(call("unsubscribeToEvent", {"ball", "Mine"}).isVoid());
  call("raiseEvent", {"ball", 2});
  EXPECT_EQ(module->calls.size(), 1U);
  EXPECT_EQ(call("unsubscribeToEvent", {"ball", "Mine"}),
            Value("! \tALMemory::unsubscribeToEvent\n\t"
                  "module Mine has not subscribed to ball"));
}

TEST_F(AlMemoryTest, RefusesToCallBackAModuleThatIsNotThere) {
  const Value answer = call("subscribeToEvent", {"ball", "Nobody", "onBall"});
  ASSERT_NE(answer.findText(), nullptr);
  EXPECT_THAT(*answer.findText(), ::testing::HasSubstr("can not call back module Nobody"));
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
}

TEST_F(AlMemoryTest, AClientThatVanishesLeavesNoCallbacksBehind) {
  const auto module = modules_["Mine"] = std::make_shared<HostedModule>();
  call("subscribeToEvent", {"ball", "Mine", "onBall"});
  call("subscribeToEvent", {"goal", "Mine", "onGoal"});
  session_->end();
  call("raiseEvent", {"ball", 1});
  EXPECT_THAT(module->calls, IsEmpty());
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
  EXPECT_EQ(memory_.store().listenerCount("goal"), 0U);
}

TEST_F(AlMemoryTest, AModuleThatVanishesIsForgottenAtTheNextRaise) {
  const auto module = modules_["Mine"] = std::make_shared<HostedModule>();
  call("subscribeToEvent", {"ball", "Mine", "onBall"});
  module->reachable = false;
  call("raiseEvent", {"ball", 1});
  EXPECT_THAT(module->calls, IsEmpty());
  EXPECT_THAT(names("getSubscribers", {"ball"}), IsEmpty());
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
}

TEST_F(AlMemoryTest, RemovingAnEventEndsItsSubscriptions) {
  const auto module = modules_["Mine"] = std::make_shared<HostedModule>();
  const auto object = subscribe("ball");
  listen(*object);
  call("subscribeToEvent", {"ball", "Mine", "onBall"});
  call("raiseEvent", {"ball", 1});
  call("removeEvent", {"ball"});
  call("raiseEvent", {"ball", 2});
  EXPECT_THAT(heard_, ElementsAre("1"));
  EXPECT_EQ(module->calls.size(), 1U);
}

TEST_F(AlMemoryTest, KeepsNoObjectsOfClients) {
  EXPECT_EQ(callUid(133, {"object", Value(subscribe("ball"))}),
            Value("! \tALMemory::insertData\n\tan object can not be kept in memory"));
}

TEST_F(AlMemoryTest, WhatOnlyARobotsInsideCanDoIsRefused) {
  EXPECT_EQ(call("getDataPtr", {kYaw}), Value("! ALMemory::getDataPtr Cannot be called remotely"));
}

TEST_F(AlMemoryTest, GetDataOnChangeEndsWhenTheValueIsAnother) {
  call("insertData", {"ball", 1});
  const auto changed = service_.call("getDataOnChange", {"ball", 0});
  al_memory_.deliver();
  EXPECT_FALSE(changed.isDone());
  call("insertData", {"ball", 2});
  al_memory_.deliver();
  ASSERT_TRUE(changed.isDone());
  EXPECT_EQ(changed.outcome()->value, Value(2));
}

TEST_F(AlMemoryTest, AMappedSignalRaisesItsEvent) {
  auto tracker = std::make_shared<rpc::Service>("Tracker", "");
  tracker->signal("lost", "(s)");
  al_memory_.setFindService([tracker](const std::string&) { return tracker; });
  call("addMapping", {"Tracker", "lost", "TargetLost"});
  tracker->emit("lost", {"ball"});
  EXPECT_EQ(call("getData", {"TargetLost"}), Value("ball"));
  EXPECT_NE(call("addMapping", {"Tracker", "found", "x"}).print().find("has no signal"),
            std::string::npos);
}

}  // namespace
}  // namespace nao::services
