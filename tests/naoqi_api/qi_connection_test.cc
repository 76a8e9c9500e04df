#include "naoqi_api/wire/qi_connection.h"

#include <gtest/gtest.h>

#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/dispatcher.h"
#include "naoqi_api/wire/metaobject.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

Address demo(std::uint32_t action) { return {2, 1, action}; }

class QiConnectionTest : public testing::Test {
 protected:
  QiConnectionTest() { client_.authenticate(); }

  Value call(std::uint32_t action, std::vector<Value> arguments, const std::string& returns) {
    client_.call(demo(action), Value::tuple(std::move(arguments)));
    return client_.nextValue(returns);
  }
  std::uint32_t cancel(std::uint32_t call) {
    Message message;
    message.id = client_.next_id++;
    message.type = MessageType::Cancel;
    message.address = {2, 1, 0};
    appendNumber(message.payload, call);
    client_.send(message);
    return message.id;
  }
  Value subscribe(TestClient& client, std::uint32_t signal, std::uint64_t link) {
    client.call(demo(0), Value::tuple({2U, signal, link}));
    return client.nextValue("L");
  }

  DemoHub demo_;
  TestClient client_{demo_.hub};
};

TEST_F(QiConnectionTest, AnswersCalls) {
  EXPECT_EQ(call(100, {"you"}, "s"), Value("hello you"));
  EXPECT_EQ(call(101, {1, 2}, "i"), Value(3));
  EXPECT_EQ(call(108, {}, "v"), Value("deliberate failure"));
}

TEST_F(QiConnectionTest, ArgumentsMayComeAsOneDynamic) {
  client_.call(demo(101), Value::tuple({std::int64_t{4}, std::int64_t{5}}), kFlagDynamic);
  EXPECT_EQ(client_.nextValue("i"), Value(9));
  client_.call(demo(101), Value::list({4, 5}), kFlagDynamic);
  EXPECT_EQ(client_.nextValue("i"), Value(9));
  client_.call(demo(101), 4, kFlagDynamic);
  EXPECT_EQ(client_.nextValue("i"), Value("The arguments of a call are a tuple, not i"));
}

TEST_F(QiConnectionTest, AWishedTypeComesAsADynamicOfIt) {
  Message message;
  message.address = demo(101);
  message.flags = kFlagReturnType;
  encode(message.payload, Value::tuple({1, 2}), Signature::of("(ii)"));
  appendText(message.payload, "d");
  client_.send(message);
  const auto reply = client_.next();
  EXPECT_EQ(reply->flags, kFlagDynamic);
  EXPECT_EQ(Decoder(reply->payload).read("m"), Value(3.0));
}

TEST_F(QiConnectionTest, AWishThatCanNotBeMetIsIgnored) {
  for (const char* wish : {"s", "(((", ""}) {
    Message message;
    message.address = demo(101);
    message.flags = kFlagReturnType | kFlagDynamic;
    encodeDynamic(message.payload, Value::tuple({1, 2}));
    appendText(message.payload, wish);
    client_.send(message);
    const auto reply = client_.next();
    EXPECT_EQ(reply->flags, 0) << wish;
    EXPECT_EQ(Decoder(reply->payload).read("i"), Value(3)) << wish;
  }
}

TEST_F(QiConnectionTest, PostsAreNeverAnswered) {
  client_.call(demo(103), Value::tuple({}), 0, MessageType::Post);
  client_.call(demo(108), Value::tuple({}), 0, MessageType::Post);  // fails
  client_.call(demo(999), Value::tuple({}), 0, MessageType::Post);
  EXPECT_EQ(demo_.demo.calls_of_nothing, 1);
  EXPECT_FALSE(client_.next());
}

TEST_F(QiConnectionTest, APendingCallNeverBlocksTheNext) {
  const auto slow = client_.call(demo(109), Value::tuple({300}));
  EXPECT_EQ(call(100, {"fast"}, "s"), Value("hello fast"));
  demo_.demo.finishSlowCalls();
  const auto reply = client_.next();
  EXPECT_EQ(reply->id, slow);
  EXPECT_EQ(Decoder(reply->payload).read("i"), Value(300));
}

TEST_F(QiConnectionTest, ACanceledCallIsAnsweredAsCanceled) {
  const auto slow = client_.call(demo(109), Value::tuple({300}));
  cancel(777);  // no such call: ignored
  EXPECT_FALSE(client_.next());
  cancel(slow);
  const auto answer = client_.next();
  EXPECT_EQ(answer->type, MessageType::Canceled);
  EXPECT_EQ(answer->id, slow);
  EXPECT_EQ(answer->address.action, 109U);
  EXPECT_TRUE(answer->payload.empty());
}

TEST_F(QiConnectionTest, ACallThatOnlyWaitsEndsWithItsClient) {
  client_.call(demo(109), Value::tuple({0}));  // only waits
  client_.call(demo(109), Value::tuple({400}));
  client_.connection.reset();
  EXPECT_TRUE(demo_.demo.slow_calls[0].first.isDone());
  EXPECT_FALSE(demo_.demo.slow_calls[1].first.isDone());
}

TEST_F(QiConnectionTest, QiloopsCancelCarriesTheCallsOwnNumber) {
  const auto slow = client_.call(demo(109), Value::tuple({300}));
  Message message;
  message.id = slow;
  message.type = MessageType::Cancel;
  message.address = demo(109);
  client_.send(message);
  EXPECT_EQ(client_.next()->type, MessageType::Canceled);
}

TEST_F(QiConnectionTest, AnOldClientIsToldOfACancelByAnError) {
  TestClient old(demo_.hub);
  old.authenticate({{"MessageFlags", true}});
  const auto slow = old.call(demo(109), Value::tuple({300}));
  Message message;
  message.id = slow;
  message.type = MessageType::Cancel;
  message.address = demo(109);
  old.send(message);
  EXPECT_EQ(old.nextValue("m"), Value("Call has been canceled."));
}

TEST_F(QiConnectionTest, UnfinishedCallsAreBounded) {
  for (std::size_t i = 0; i < Dispatcher::kMostUnfinished; ++i) {
    client_.call(demo(109), Value::tuple({1}));
  }
  EXPECT_FALSE(client_.next());
  EXPECT_EQ(call(109, {1}, "i"), Value("too many unfinished calls"));
  demo_.demo.finishSlowCalls();
  client_.received.clear();
  EXPECT_EQ(call(101, {1, 2}, "i"), Value(3));
}

TEST_F(QiConnectionTest, AClientThatVanishesMidCallIsForgotten) {
  client_.call(demo(109), Value::tuple({300}));
  subscribe(client_, 112, 5);
  client_.connection.reset();
  EXPECT_EQ(demo_.demo.tick.emitter().listenerCount(), 0U);
  demo_.demo.finishSlowCalls();
  demo_.demo.tick(1, "x");
  EXPECT_FALSE(client_.next());
}

TEST_F(QiConnectionTest, EventsComeBeforeTheReplyOfTheCallThatRaisedThem) {
  subscribe(client_, 112, 5);
  const auto fire = client_.call(demo(111), Value::tuple({42}));
  const auto event = client_.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->type, MessageType::Event);
  EXPECT_EQ(event->address.action, 112U);
  EXPECT_EQ(Decoder(event->payload).read("(is)"), Value::tuple({42, "tick"}));
  EXPECT_EQ(client_.next()->id, fire);
}

TEST_F(QiConnectionTest, EverySubscriberIsToldUntilItUnsubscribes) {
  TestClient other(demo_.hub);
  other.authenticate();
  subscribe(client_, 112, 5);
  subscribe(other, 112, 5);
  demo_.demo.tick(1, "x");
  EXPECT_EQ(client_.received.size(), 1U);
  EXPECT_EQ(other.received.size(), 1U);
  client_.received.clear();
  EXPECT_EQ(call(1, {2U, 112U, std::uint64_t{5}}, "v"), Value());
  demo_.demo.tick(2, "x");
  EXPECT_TRUE(client_.received.empty());
  EXPECT_EQ(other.received.size(), 2U);
}

TEST_F(QiConnectionTest, SubscriptionsAreBounded) {
  for (std::uint64_t i = 0; i < Subscriptions::kMost; ++i) subscribe(client_, 112, i);
  EXPECT_EQ(call(0, {2U, 112U, std::uint64_t{9999}}, "L"),
            Value("too many subscriptions on one connection"));
}

TEST_F(QiConnectionTest, EventsComeInTheWishedTypes) {
  call(8, {2U, 112U, std::uint64_t{7}, "(ls)"}, "L");
  demo_.demo.tick(9, "x");
  const auto event = client_.next();
  EXPECT_EQ(event->flags, kFlagDynamic);
  EXPECT_EQ(Decoder(event->payload).read("m"), Value::tuple({std::int64_t{9}, "x"}));
}

TEST_F(QiConnectionTest, AClientMayEmitASignal) {
  subscribe(client_, 112, 5);
  client_.call(demo(112), Value::tuple({8, "me"}), 0, MessageType::Post);
  EXPECT_EQ(client_.nextValue("(is)"), Value::tuple({8, "me"}));
}

TEST_F(QiConnectionTest, PropertiesAreReadSetAndWatched) {
  EXPECT_EQ(call(5, {Value::dynamic("level")}, "m"), Value(0.5F));
  subscribe(client_, 113, 5);
  client_.call(demo(6), Value::tuple("(mm)", {113U, 3}));  // an int becomes the declared float
  EXPECT_EQ(client_.nextValue("(f)"), Value::tuple({3.0F}));
  EXPECT_EQ(client_.nextValue("v"), Value());
  EXPECT_EQ(demo_.demo.level.get(), 3.0F);
  client_.call(demo(6), Value::tuple("(mm)", {"level", "x"}));
  EXPECT_EQ(client_.nextValue("v"),
            Value("Failed to set object property '113', reason: Conversion from s to f failed"));
}

TEST_F(QiConnectionTest, ObjectsByValueLiveUntilTheClientDropsThem) {
  client_.call(demo(110), Value::tuple({}));
  const auto reply = client_.next();
  Decoder decoder(reply->payload);
  decoder.read(metaObjectSignature());
  EXPECT_EQ(decoder.number<std::uint32_t>(), 2U);
  const auto object = decoder.number<std::uint32_t>();
  EXPECT_EQ(decoder.left(), 20U);  // uid
  client_.call({2, object, 100}, Value::tuple({}));
  EXPECT_EQ(client_.nextValue("s"), Value("helper"));
  EXPECT_FALSE(demo_.demo.last_helper.expired());
  client_.call({2, object, 3}, Value::tuple({2U}), 0, MessageType::Post);
  EXPECT_TRUE(demo_.demo.last_helper.expired());
  client_.call({2, object, 100}, Value::tuple({}));
  EXPECT_EQ(client_.nextValue("s"), Value("The call request could not be handled."));
}

TEST_F(QiConnectionTest, ObjectsByValueEndWithTheConnection) {
  client_.call(demo(110), Value::tuple({}));
  EXPECT_FALSE(demo_.demo.last_helper.expired());
  client_.connection.reset();
  EXPECT_TRUE(demo_.demo.last_helper.expired());
}

TEST_F(QiConnectionTest, ObjectsByValueAreReachedByTheirOwnClientOnly) {
  client_.call(demo(110), Value::tuple({}));
  TestClient other(demo_.hub);
  other.authenticate();
  other.call({2, 3, 100}, Value::tuple({}));
  EXPECT_EQ(other.nextValue("s"), Value("The call request could not be handled."));
}

TEST_F(QiConnectionTest, UidsOfObjectsTravelOnlyIfBothEndsKnowThem) {
  TestClient old(demo_.hub);
  old.authenticate({{"MessageFlags", true}});
  old.call(demo(110), Value::tuple({}));
  const auto reply = old.next();
  Decoder decoder(reply->payload);
  decoder.read(metaObjectSignature());
  EXPECT_EQ(decoder.left(), 8U);
}

TEST_F(QiConnectionTest, MetaObjectsExplainMembers) {
  const Value metaobject = call(2, {0U}, metaObjectSignature());
  const auto& methods = (*metaobject.findItems())[0].find<Value::Map>()->entries;
  EXPECT_EQ(methods.size(), 14U + 12U);
  client_.call({1, 1, 2}, Value::tuple({0U}));
  const Value directory = client_.nextValue(metaObjectSignature());
  const auto& service = (*directory.findItems())[0].find<Value::Map>()->entries[14].second;
  EXPECT_EQ((*service.findItems())[2], Value("service"));
  EXPECT_EQ((*service.findItems())[4], Value("Where a service is."));
  EXPECT_EQ((*service.findItems())[5].findItems()->size(), 1U);
}

TEST_F(QiConnectionTest, StatisticsCountCalls) {
  call(81, {true}, "v");
  call(100, {"x"}, "s");
  call(100, {"y"}, "s");
  const Value statistics = call(82, {}, rpc::Monitor::kStatisticsSignature);
  const auto& entries = statistics.find<Value::Map>()->entries;
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].first, Value(100U));
  EXPECT_EQ((*entries[0].second.findItems())[0], Value(2U));
  call(83, {}, "v");
  EXPECT_TRUE(call(82, {}, rpc::Monitor::kStatisticsSignature).find<Value::Map>()->entries.empty());
}

TEST_F(QiConnectionTest, TracesTellOfCallsAndResults) {
  subscribe(client_, 86, 5);
  call(85, {true}, "v");
  client_.call(demo(101), Value::tuple({1, 2}));
  const auto kind = [&] {
    const Value event = client_.nextValue(rpc::Monitor::kTraceSignature);
    return (*(*event.findItems())[0].findItems())[1].to<int>();
  };
  EXPECT_EQ(kind(), 1);
  EXPECT_EQ(client_.nextValue("i"), Value(3));
  EXPECT_EQ(kind(), 2);  // after the reply, as a real server does
}

TEST_F(QiConnectionTest, TracesTellOfSignals) {
  subscribe(client_, 86, 5);
  demo_.demo.tick(7, "x");
  const Value event = client_.nextValue(rpc::Monitor::kTraceSignature);
  const auto& fields = *(*event.findItems())[0].findItems();
  EXPECT_EQ(fields[1], Value(4));
  EXPECT_EQ(fields[2], Value(112U));
  EXPECT_EQ(fields[3], Value::list({7, "x"}));
}

/// A client that holds an object with a signal, handed out by value.
class ObjectByValue : public QiConnectionTest {
 protected:
  ObjectByValue() {
    const std::function<std::shared_ptr<rpc::Service>()> give = [this] { return bell_; };
    const std::uint32_t giver = demo_.hub.add(rpc::Service("Giver", "").method("give", give, ""));
    for (int i = 0; i < 2; ++i) {
      client_.call({giver, 1, 100}, Value::tuple({}));
      const auto reply = client_.next();
      Decoder decoder(reply->payload);
      decoder.read(metaObjectSignature());
      decoder.number<std::uint32_t>();
      object_ = {giver, decoder.number<std::uint32_t>(), 0};
    }
  }
  Value ask(std::uint32_t action, std::vector<Value> arguments, const std::string& returns) {
    client_.call({object_.service, object_.object, action}, Value::tuple(std::move(arguments)));
    return client_.nextValue(returns);
  }
  static std::shared_ptr<rpc::Service> makeBell(const rpc::Signal<int>& ring) {
    const std::function<int(int)> twice = [](int number) { return 2 * number; };
    return std::make_shared<rpc::Service>(
        rpc::Service("Bell", "").method("twice", twice, "", rpc::Argument{}).signal("ring", ring));
  }

  rpc::Signal<int> ring_;
  std::shared_ptr<rpc::Service> bell_ = makeBell(ring_);
  Address object_;
};

TEST_F(ObjectByValue, ItsTraceTellsOfItsCallsAndOnceOfEachSignal) {
  ask(0, {object_.service, 86U, std::uint64_t{5}}, "L");
  const auto traced = [&] {
    const Value event = client_.nextValue(rpc::Monitor::kTraceSignature);
    return (*event.findItems())[0].findItems()->at(1).to<int>();
  };
  ring_(7);
  EXPECT_EQ(traced(), 4);
  EXPECT_FALSE(client_.next());
  client_.call({object_.service, object_.object, 100}, Value::tuple({4}));
  EXPECT_EQ(traced(), 1);
  EXPECT_EQ(client_.nextValue("i"), Value(8));
  EXPECT_EQ(traced(), 2);
}

TEST_F(ObjectByValue, ItsStatisticsCountItsCalls) {
  ask(81, {true}, "v");
  EXPECT_EQ(ask(100, {4}, "i"), Value(8));
  const Value statistics = ask(82, {}, rpc::Monitor::kStatisticsSignature);
  ASSERT_EQ(statistics.find<Value::Map>()->entries.size(), 1U);
  EXPECT_EQ(statistics.find<Value::Map>()->entries[0].first, Value(100U));
}

TEST_F(QiConnectionTest, AnotherVersionOfTheProtocolIsRefused) {
  Message message;
  message.version = 1;
  message.address = demo(2);
  client_.send(message);
  EXPECT_EQ(client_.nextValue("m"),
            Value("Cannot negotiate QiMessaging connection: remote end doesn't support binary "
                  "protocol v1"));
}

TEST_F(QiConnectionTest, UnknownTargetsAndActionsAreErrors) {
  client_.call({77, 1, 100}, Value::tuple({}));
  EXPECT_EQ(client_.nextValue("v"), Value("The call request could not be handled."));
  const auto id = client_.call({2, 1, 999}, Value::tuple({}));
  EXPECT_EQ(client_.nextValue("v"),
            Value("No such method {2.1.999, id:" + std::to_string(id) + "}"));
  client_.call({2, 1, 4}, Value::tuple({}));
  EXPECT_EQ(client_.next()->type, MessageType::Error);
}

}  // namespace
}  // namespace nao::wire
