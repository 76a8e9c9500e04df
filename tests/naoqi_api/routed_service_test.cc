// Services that a client hosts, used by other clients through the daemon.
#include <gtest/gtest.h>

#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/metaobject.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

constexpr char kInfo[] =
    "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>";

/// A client that hosts a service which offers what Demo does, and one that uses it.
class RoutedService : public testing::Test {
 protected:
  RoutedService() {
    host_.authenticate();
    user_.authenticate();
    const Value info =
        Value::tuple(kInfo, {"Module", 0U, "machine", 7U, Value::listOf("s", {}), "session"});
    host_.call({1, 1, 102}, Value::tuple({info}));
    id_ = host_.nextValue("I").to<std::uint32_t>();
    host_.call({1, 1, 104}, Value::tuple({id_}));
    host_.received.clear();
  }

  // The host says what it offers, once it is asked.
  void tellOffer() {
    const auto ask = host_.next();
    ASSERT_TRUE(ask);
    ASSERT_EQ(ask->address.action, base_action::kMetaObject);
    answer(*ask, metaObjectOf(*demo_.hub.findService("Demo"), false));
  }

  void answer(const Message& call, const Value& value) {
    Message message;
    message.id = call.id;
    message.type = MessageType::Reply;
    message.address = call.address;
    encode(message.payload, value, Signature::of(value.signature()));
    host_.send(message);
  }

  void raise(std::uint32_t signal, const Value& arguments) {
    Message message;
    message.type = MessageType::Event;
    message.address = {id_, 1, signal};
    encode(message.payload, arguments, Signature::of(arguments.signature()));
    host_.send(message);
  }

  DemoHub demo_;
  TestClient host_{demo_.hub};
  TestClient user_{demo_.hub};
  std::uint32_t id_ = 0;
};

TEST_F(RoutedService, IsCalledOnItsHostsConnection) {
  const auto id = user_.call({id_, 1, 101}, Value::tuple({1, 2}));
  tellOffer();
  const auto call = host_.next();
  ASSERT_TRUE(call);
  EXPECT_EQ(call->address.service, id_);
  EXPECT_EQ(Decoder(call->payload).read("(ii)"), Value::tuple({1, 2}));
  EXPECT_FALSE(user_.next());
  answer(*call, 3);
  const auto reply = user_.next();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->id, id);
  EXPECT_EQ(Decoder(reply->payload).read("i"), Value(3));
}

TEST_F(RoutedService, IsAskedOnceWhatItOffersAndTellsItOn) {
  user_.call({id_, 1, base_action::kMetaObject}, Value::tuple({0U}));
  tellOffer();
  const Value offer = user_.nextValue(metaObjectSignature());
  EXPECT_EQ(offer, metaObjectOf(*demo_.hub.findService("Demo"), false));
  user_.call({id_, 1, base_action::kMetaObject}, Value::tuple({0U}));
  EXPECT_FALSE(host_.next());
  EXPECT_TRUE(user_.next());
}

TEST_F(RoutedService, ItsEventsReachThoseWhoListenUntilNobodyDoes) {
  const std::uint32_t tick = 112;
  user_.call({id_, 1, base_action::kRegisterEvent}, Value::tuple({id_, tick, std::uint64_t{5}}));
  tellOffer();
  const auto listening = host_.next();
  ASSERT_TRUE(listening);
  EXPECT_EQ(listening->address.action, base_action::kRegisterEvent);
  answer(*listening, std::uint64_t{1});
  user_.received.clear();
  raise(tick, Value::tuple({42, "tick"}));
  const auto event = user_.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->type, MessageType::Event);
  EXPECT_EQ(event->address.service, id_);
  EXPECT_EQ(event->address.action, tick);
  EXPECT_EQ(Decoder(event->payload).read("(is)"), Value::tuple({42, "tick"}));

  user_.call({id_, 1, base_action::kUnregisterEvent}, Value::tuple({id_, tick, std::uint64_t{5}}));
  const auto ended = host_.next();
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->address.action, base_action::kUnregisterEvent);
  user_.received.clear();
  raise(tick, Value::tuple({43, "tick"}));
  EXPECT_FALSE(user_.next());
}

TEST_F(RoutedService, ItsPropertiesAreReadAndSetThere) {
  const std::uint32_t level = 113;
  user_.call({id_, 1, base_action::kProperty}, Value::tuple("(m)", {level}));
  tellOffer();
  const auto get = host_.next();
  ASSERT_TRUE(get);
  EXPECT_EQ(get->address.action, base_action::kProperty);
  Message reply;
  reply.id = get->id;
  reply.type = MessageType::Reply;
  reply.address = get->address;
  encodeDynamic(reply.payload, 0.75F);
  host_.send(reply);
  EXPECT_EQ(user_.nextValue("m"), Value(0.75F));

  user_.call({id_, 1, base_action::kSetProperty}, Value::tuple("(mm)", {level, 1.0}));
  const auto set = host_.next();
  ASSERT_TRUE(set);
  EXPECT_EQ(Decoder(set->payload).read("(mm)"), Value::tuple("(mm)", {level, 1.0F}));
  answer(*set, Value());
  EXPECT_EQ(user_.next()->type, MessageType::Reply);
}

TEST_F(RoutedService, CancelingIsPassedOn) {
  const auto id = user_.call({id_, 1, 109}, Value::tuple({1000}));
  tellOffer();
  const auto call = host_.next();
  ASSERT_TRUE(call);
  Message cancel;
  cancel.type = MessageType::Cancel;
  cancel.address = {id_, 1, 0};
  appendNumber(cancel.payload, id);
  user_.send(cancel);
  EXPECT_EQ(user_.next()->type, MessageType::Canceled);
  const auto passed_on = host_.next();
  ASSERT_TRUE(passed_on);
  EXPECT_EQ(passed_on->type, MessageType::Cancel);
  EXPECT_EQ(readNumber<std::uint32_t>(passed_on->payload.data()), call->id);
}

TEST_F(RoutedService, CallsFailWhenItsHostGoes) {
  const auto waiting = user_.call({id_, 1, 100}, Value::tuple({"x"}));
  tellOffer();
  ASSERT_TRUE(host_.next());
  host_.connection.reset();
  const auto error = user_.next();
  ASSERT_TRUE(error);
  EXPECT_EQ(error->type, MessageType::Error);
  EXPECT_EQ(error->id, waiting);
  user_.call({id_, 1, 100}, Value::tuple({"x"}));
  EXPECT_EQ(user_.next()->type, MessageType::Error);
}

TEST_F(RoutedService, ItsHostGoingBeforeItAnswersIsAnError) {
  user_.call({id_, 1, 100}, Value::tuple({"x"}));
  host_.connection.reset();
  EXPECT_EQ(user_.next()->type, MessageType::Error);
}

TEST_F(RoutedService, ThoseThatWaitForItsOfferAreBounded) {
  std::size_t errors = 0;
  for (std::size_t k = 0; k < 100; ++k) {
    user_.call({id_, 1, 103}, Value::tuple({}));
    if (user_.next()) ++errors;
  }
  EXPECT_EQ(errors, 100U - 64U);
}

}  // namespace
}  // namespace nao::wire
