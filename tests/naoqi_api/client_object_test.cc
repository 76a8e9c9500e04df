// Objects and services that a client hosts, called from here.

#include "naoqi_api/wire/client_object.h"

#include <gtest/gtest.h>

#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/metaobject.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

constexpr std::uint32_t kCallback = 0x80000001;
constexpr char kUid[] = "01234567890123456789";

/// Keeps the callback it is given.
struct Keeper {
  void keep(const rpc::ObjectRef& object) { kept = object; }
  rpc::Service describe() {
    return rpc::Service("Keeper", "")
        .method("keep", this, &Keeper::keep, "", rpc::Argument{"object", ""});
  }
  rpc::ObjectRef kept;
};

class ClientObjectTest : public testing::Test {
 protected:
  ClientObjectTest() {
    keeper_id_ = demo_.hub.add(keeper_.describe());
    client_.authenticate();
  }

  // The client passes an object that offers what Demo does.
  void passCallback() {
    Message message;
    message.id = client_.next_id++;
    message.address = {keeper_id_, 1, 100};
    encode(message.payload, metaObjectOf(*demo_.hub.findService("Demo"), false),
           Signature::of(metaObjectSignature()));
    appendNumber(message.payload, keeper_id_);
    appendNumber(message.payload, kCallback);
    message.payload.insert(message.payload.end(), kUid, kUid + 20);
    client_.send(message);
    ASSERT_EQ(client_.next()->type, MessageType::Reply);
    ASSERT_TRUE(keeper_.kept.remote);
  }

  // A service of the client, found by its name.
  std::shared_ptr<rpc::RemoteObject> registerModule() {
    services::ServiceInfo info;
    info.name = "Module";
    client_.call({1, 1, 102}, Value::tuple({toValue(info, services::ServiceInfoFields::Six)}));
    const auto id = client_.nextValue("I").to<std::uint32_t>();
    client_.call({1, 1, 104}, Value::tuple({id}));
    client_.received.clear();
    return demo_.hub.findRemote("Module");
  }

  // The client answers a call that came.
  void answer(const Message& call, const Value& value, MessageType type = MessageType::Reply) {
    Message message;
    message.id = call.id;
    message.type = type;
    message.address = call.address;
    if (type == MessageType::Error) {
      encodeDynamic(message.payload, value);
    } else {
      encode(message.payload, value, Signature::of(value.signature()));
    }
    client_.send(message);
  }

  DemoHub demo_;
  Keeper keeper_;
  std::uint32_t keeper_id_ = 0;
  TestClient client_{demo_.hub};
};

TEST_F(ClientObjectTest, ACallbackIsCalledOnItsClientsConnection) {
  passCallback();
  const auto result = keeper_.kept.remote->call("add", {1, 2});
  const auto call = client_.next();
  ASSERT_TRUE(call);
  EXPECT_EQ(call->type, MessageType::Call);
  EXPECT_EQ(call->address.object, kCallback);
  EXPECT_EQ(call->address.action, 101U);
  EXPECT_EQ(Decoder(call->payload).read("(ii)"), Value::tuple({1, 2}));
  EXPECT_FALSE(result.isDone());
  answer(*call, 3);
  EXPECT_EQ(*result.outcome()->value, Value(3));
}

TEST_F(ClientObjectTest, ItsErrorsArePassedOn) {
  passCallback();
  const auto result = keeper_.kept.remote->call("fail", {});
  answer(*client_.next(), "oh no", MessageType::Error);
  EXPECT_EQ(*result.outcome()->error, "oh no");
}

TEST_F(ClientObjectTest, AnAnswerThatIsNotOfItsTypeIsAnError) {
  passCallback();
  const auto result = keeper_.kept.remote->call("add", {1, 2});
  answer(*client_.next(), true);
  EXPECT_EQ(*result.outcome()->error, "ISerialization error Status Read Past End");
}

TEST_F(ClientObjectTest, WhatItDoesNotOfferIsAnErrorAndNothingIsSent) {
  passCallback();
  const auto result = keeper_.kept.remote->call("dance", {});
  EXPECT_TRUE(result.outcome()->error);
  EXPECT_FALSE(client_.next());
}

TEST_F(ClientObjectTest, CallsFailWhenTheClientHasGone) {
  passCallback();
  const auto before = keeper_.kept.remote->call("add", {1, 2});
  client_.connection.reset();
  EXPECT_EQ(*before.outcome()->error, "the client has gone");
  EXPECT_FALSE(keeper_.kept.remote->isReachable());
  const auto after = keeper_.kept.remote->call("add", {1, 2});
  EXPECT_EQ(*after.outcome()->error, "the client has gone");
}

TEST_F(ClientObjectTest, TheClientIsToldWhenItIsNeededNoMore) {
  passCallback();
  keeper_.kept = {};
  const auto terminate = client_.next();
  ASSERT_TRUE(terminate);
  EXPECT_EQ(terminate->type, MessageType::Post);
  EXPECT_EQ(terminate->address.object, kCallback);
  EXPECT_EQ(terminate->address.action, 3U);
}

TEST_F(ClientObjectTest, AnObjectOfOursComesBackAsItself) {
  Message message;
  message.address = {keeper_id_, 1, 100};
  encode(message.payload, metaObjectOf(rpc::Service("", ""), false),
         Signature::of(metaObjectSignature()));
  appendNumber(message.payload, std::uint32_t{2});
  appendNumber(message.payload, std::uint32_t{1});
  message.payload.insert(message.payload.end(), kUid, kUid + 20);
  client_.send(message);
  EXPECT_EQ(keeper_.kept.local, demo_.hub.findService("Demo"));
}

TEST_F(ClientObjectTest, AServiceOfAClientIsAskedWhatItOffersThenCalled) {
  const auto remote = registerModule();
  ASSERT_TRUE(remote);
  const auto result = remote->call("say", {"x"});
  const auto ask = client_.next();
  ASSERT_TRUE(ask);
  EXPECT_EQ(ask->address.service, demo_.hub.find("Module")->id);
  EXPECT_EQ(ask->address.action, base_action::kMetaObject);
  answer(*ask, metaObjectOf(*demo_.hub.findService("Demo"), false));
  const auto call = client_.next();
  ASSERT_TRUE(call);
  EXPECT_EQ(Decoder(call->payload).read("(s)"), Value::tuple({"x"}));
  answer(*call, "fine");
  EXPECT_EQ(*result.outcome()->value, Value("fine"));
  EXPECT_EQ(demo_.hub.findRemote("Demo"), nullptr);
}

TEST_F(ClientObjectTest, ADynamicInsteadOfAMetaObjectIsAnError) {
  const auto remote = registerModule();
  ASSERT_TRUE(remote);
  const auto result = remote->call("say", {"x"});
  const auto ask = client_.next();
  ASSERT_TRUE(ask);
  Message message;
  message.id = ask->id;
  message.type = MessageType::Reply;
  message.flags = kFlagDynamic;
  message.address = ask->address;
  encodeDynamic(message.payload, Value::tuple({Value::Map{"I", "i", {{Value(1U), Value(2)}}}}));
  client_.send(message);
  ASSERT_TRUE(result.isDone());
  EXPECT_TRUE(result.outcome()->error);
}

}  // namespace
}  // namespace nao::wire
