// ALMemory as a client on the wire meets it.

#include <gtest/gtest.h>

#include <string>

#include "naoqi_api/services/al_memory.h"
#include "naoqi_api/wire/metaobject.h"
#include "tests/naoqi_api/test_client.h"
#include "tests/support/models.h"

namespace nao::services {
namespace {

using rpc::Value;
using wire::Address;
using wire::Message;
using wire::MessageType;

class AlMemoryWireTest : public ::testing::Test {
 protected:
  AlMemoryWireTest() : id_(hub_.add(al_memory_.describe())) {
    client_.authenticate();
    other_.authenticate();
  }

  // The object that subscriber(event) returns.
  Address subscribe(const std::string& event) {
    client_.call({id_, 1, 117}, Value::tuple({event}));
    const auto reply = client_.next();
    if (!reply || reply->type != MessageType::Reply) return {};
    const std::string signature = "(" + std::string(wire::metaObjectSignature()) + "II)";
    const Value object = wire::Decoder(reply->payload).read(signature);
    const auto& parts = *object.findItems();
    return {parts[1].to<std::uint32_t>(), parts[2].to<std::uint32_t>(), 100};
  }

  void registerFor(const Address& signal) {
    const Value arguments =
        Value::tuple({signal.service, signal.action, std::uint64_t{signal.action} << 32U});
    client_.call({signal.service, signal.object, 0}, arguments);
    const auto reply = client_.next();
    ASSERT_TRUE(reply);
    ASSERT_EQ(reply->type, MessageType::Reply);
  }

  // The client hosts a module with the method onBall(event, value, message).
  void registerModule() {
    services::ServiceInfo info;
    info.name = "Module";
    client_.call({1, 1, 102}, Value::tuple({toValue(info, ServiceInfoFields::Six)}));
    const auto id = client_.nextValue("I").to<std::uint32_t>();
    client_.call({1, 1, 104}, Value::tuple({id}));
    client_.received.clear();
  }
  void answer(const Message& call, const Value& value) {
    Message reply;
    reply.id = call.id;
    reply.type = MessageType::Reply;
    reply.address = call.address;
    wire::encode(reply.payload, value, rpc::Signature::of(value.signature()));
    client_.send(reply);
  }
  static Value describeModule() {
    const std::function<void(std::string, Value, std::string)> on_ball =
        [](const std::string&, const Value&, const std::string&) {};
    rpc::Service module("Module", "");
    module.method("onBall", on_ball, "", rpc::Argument{}, rpc::Argument{}, rpc::Argument{});
    return wire::metaObjectOf(module, false);
  }

  void raise(wire::TestClient& client, const std::string& event, const Value& value) {
    client.call({id_, 1, 135}, Value::tuple("(sm)", {event, value}));
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  memory::RobotMemory memory_{*model_, std::make_shared<motion::RobotPorts>(), "nao",
                              [] { return Duration(); }};
  AlMemory al_memory_{memory_, [this](const std::string& name) { return hub_.findRemote(name); }};
  rpc::ServiceHub hub_{wire::DemoHub::options(rpc::Personality::naoqi(), {})};
  std::uint32_t id_;
  wire::TestClient client_{hub_};
  wire::TestClient other_{hub_};
};

TEST_F(AlMemoryWireTest, TheEventComesBeforeTheReplyOfTheCallThatRaisedIt) {
  const Address signal = subscribe("ball");
  registerFor(signal);
  raise(client_, "ball", 5);
  const auto event = client_.next();
  const auto reply = client_.next();
  ASSERT_TRUE(event && reply);
  EXPECT_EQ(event->type, MessageType::Event);
  EXPECT_EQ(event->address.object, signal.object);
  EXPECT_EQ(event->address.action, signal.action);
  EXPECT_EQ(wire::Decoder(event->payload).read("(m)"), Value::tuple("(m)", {5}));
  EXPECT_EQ(reply->type, MessageType::Reply);
}

TEST_F(AlMemoryWireTest, HearsWhatOtherClientsRaise) {
  registerFor(subscribe("ball"));
  raise(other_, "ball", 1);
  raise(other_, "ball", 2);
  for (const int value : {1, 2}) {
    const auto event = client_.next();
    ASSERT_TRUE(event);
    EXPECT_EQ(wire::Decoder(event->payload).read("(m)"), Value::tuple("(m)", {value}));
  }
  EXPECT_FALSE(client_.next());
}

TEST_F(AlMemoryWireTest, AnObjectThatTheClientDropsHearsNoMore) {
  const Address signal = subscribe("ball");
  registerFor(signal);
  client_.call({signal.service, signal.object, 3}, Value::tuple({signal.service}), 0,
               MessageType::Post);
  raise(other_, "ball", 1);
  EXPECT_FALSE(client_.next());
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
}

TEST_F(AlMemoryWireTest, AClientThatVanishesLeavesNothingBehind) {
  for (int i = 0; i < 3; ++i) registerFor(subscribe("ball"));
  EXPECT_EQ(memory_.store().listenerCount("ball"), 1U);  // for all who subscribed
  client_.connection.reset();
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
  raise(other_, "ball", 1);
  EXPECT_EQ(other_.next()->type, MessageType::Reply);
}

TEST_F(AlMemoryWireTest, ASubscriberOfAnEventThatWasRemovedMeanwhileHears) {
  registerFor(subscribe("ball"));
  hub_.findService("ALMemory")->call("removeEvent", {"ball"});
  registerFor(subscribe("ball"));
  raise(other_, "ball", 1);
  EXPECT_TRUE(client_.next());
  EXPECT_FALSE(client_.next());  // the first hears no more
}

TEST_F(AlMemoryWireTest, CallsTheModuleOfAClientWithoutWaitingForIt) {
  registerModule();
  client_.call({id_, 1, 140}, Value::tuple({"ball", "Module", "onBall"}));
  ASSERT_EQ(client_.next()->type, MessageType::Reply);
  raise(other_, "ball", 5);
  EXPECT_EQ(other_.next()->type, MessageType::Reply);
  const auto question = client_.next();
  ASSERT_TRUE(question);
  EXPECT_EQ(question->address.action, 2U);  // what the module offers
  answer(*question, describeModule());
  const auto call = client_.next();
  ASSERT_TRUE(call);
  EXPECT_EQ(call->type, MessageType::Call);
  EXPECT_EQ(wire::Decoder(call->payload).read("(sms)"), Value::tuple("(sms)", {"ball", 5, ""}));
}

TEST_F(AlMemoryWireTest, AMicroEventCallsTheModuleEachTimeWithTheMessageOfItsSubscription) {
  const auto uid = [this](const char* name, const std::vector<Value>& arguments) {
    return hub_.findService("ALMemory")->findMethod(name, arguments)->uid;
  };
  registerModule();
  client_.call({id_, 1, uid("subscribeToMicroEvent", {"", "", "", ""})},
               Value::tuple({"micro", "Module", "hello", "onBall"}));
  ASSERT_EQ(client_.next()->type, MessageType::Reply);
  const Address raise_micro{id_, 1, uid("raiseMicroEvent", {"", 0})};
  for (int i = 0; i < 2; ++i) {  // the same value: an event would come once
    other_.call(raise_micro, Value::tuple("(sm)", {"micro", 5}));
    EXPECT_EQ(other_.next()->type, MessageType::Reply);
  }
  const auto question = client_.next();
  ASSERT_TRUE(question);
  answer(*question, describeModule());
  for (int i = 0; i < 2; ++i) {
    const auto call = client_.next();
    ASSERT_TRUE(call) << i;
    EXPECT_EQ(wire::Decoder(call->payload).read("(sms)"),
              Value::tuple("(sms)", {"micro", 5, "hello"}));
    answer(*call, Value());
  }
  client_.call({id_, 1, uid("unsubscribeToMicroEvent", {"", ""})},
               Value::tuple({"micro", "Module"}));
  ASSERT_EQ(client_.next()->type, MessageType::Reply);
  other_.call(raise_micro, Value::tuple("(sm)", {"micro", 6}));
  EXPECT_FALSE(client_.next());
}

TEST_F(AlMemoryWireTest, AModulesSubscriptionGoesWithItsClient) {
  registerModule();
  client_.call({id_, 1, 140}, Value::tuple({"ball", "Module", "onBall"}));
  EXPECT_EQ(memory_.store().listenerCount("ball"), 1U);
  client_.connection.reset();
  EXPECT_EQ(memory_.store().listenerCount("ball"), 0U);
}

TEST_F(AlMemoryWireTest, AMissingKeyIsAnErrorWithTheKnownText) {
  client_.call({id_, 1, 115}, Value::tuple({"Nope"}));
  const auto error = client_.next();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->type, MessageType::Error);
  EXPECT_EQ(wire::Decoder(error->payload).read("m"),
            Value("\tALMemory::getData\n\tData not found Nope"));
}

}  // namespace
}  // namespace nao::services
