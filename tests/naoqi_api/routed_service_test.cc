// Services that a client hosts, used by other clients through the daemon.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/client_calls.h"
#include "naoqi_api/wire/metaobject.h"
#include "naoqi_api/wire/named_calls.h"
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

  void listenTo(std::uint32_t signal) {
    user_.call({id_, 1, base_action::kRegisterEvent},
               Value::tuple({id_, signal, std::uint64_t{5}}));
  }

  struct SetAlarm {
    Duration after;
    std::function<void()> then;
  };
  rpc::Alarm alarm() {
    return [this](Duration after, std::function<void()> then) {
      alarms_.push_back({after, std::move(then)});
      return [] {};
    };
  }

  static constexpr std::uint32_t kTick = 112;  // (is)

  std::vector<SetAlarm> alarms_;  // never go off by themselves
  DemoHub demo_{rpc::Personality::naoqi(), alarm()};
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
  listenTo(kTick);
  tellOffer();
  const auto listening = host_.next();
  ASSERT_TRUE(listening);
  EXPECT_EQ(listening->address.action, base_action::kRegisterEvent);
  answer(*listening, std::uint64_t{1});
  user_.received.clear();
  raise(kTick, Value::tuple({42, "tick"}));
  const auto event = user_.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->type, MessageType::Event);
  EXPECT_EQ(event->address.service, id_);
  EXPECT_EQ(event->address.action, kTick);
  EXPECT_EQ(Decoder(event->payload).read("(is)"), Value::tuple({42, "tick"}));

  user_.call({id_, 1, base_action::kUnregisterEvent}, Value::tuple({id_, kTick, std::uint64_t{5}}));
  const auto ended = host_.next();
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->address.action, base_action::kUnregisterEvent);
  user_.received.clear();
  raise(kTick, Value::tuple({43, "tick"}));
  EXPECT_FALSE(user_.next());
}

TEST_F(RoutedService, RegisteringIsAnsweredOnceItsHostHasAnswered) {
  listenTo(kTick);
  tellOffer();
  const auto listening = host_.next();
  ASSERT_TRUE(listening);
  EXPECT_FALSE(user_.next());
  raise(kTick, Value::tuple({1, "at once"}));
  EXPECT_EQ(user_.next()->type, MessageType::Event);
  answer(*listening, std::uint64_t{1});
  EXPECT_EQ(user_.next()->type, MessageType::Reply);
}

TEST_F(RoutedService, WhoComesWhileItsHostIsAskedWaitsToo) {
  TestClient second(demo_.hub);
  second.authenticate();
  listenTo(kTick);
  tellOffer();
  const auto listening = host_.next();
  second.call({id_, 1, base_action::kRegisterEvent}, Value::tuple({id_, kTick, std::uint64_t{5}}));
  EXPECT_FALSE(host_.next());  // asked once
  EXPECT_FALSE(second.next());
  answer(*listening, std::uint64_t{1});
  EXPECT_EQ(second.next()->type, MessageType::Reply);
}

TEST_F(RoutedService, AHostThatNeverAnswersDelaysARegistrationByABoundAlone) {
  listenTo(kTick);
  tellOffer();
  ASSERT_EQ(alarms_.size(), 1U);
  EXPECT_EQ(alarms_[0].after, ClientCalls::kMostListenWait);
  EXPECT_FALSE(user_.next());
  alarms_[0].then();
  EXPECT_EQ(user_.next()->type, MessageType::Reply);
  raise(kTick, Value::tuple({1, "late"}));
  EXPECT_EQ(user_.next()->type, MessageType::Event);
}

TEST_F(RoutedService, ARegistrationThatItsHostRefusesIsNone) {
  listenTo(kTick);
  tellOffer();
  const auto listening = host_.next();
  ASSERT_TRUE(listening);
  Message error;
  error.id = listening->id;
  error.type = MessageType::Error;
  error.address = listening->address;
  encodeDynamic(error.payload, "no such signal");
  host_.send(error);
  EXPECT_EQ(user_.nextValue("m"), Value("no such signal"));
  host_.received.clear();
  raise(kTick, Value::tuple({1, "unheard"}));
  EXPECT_FALSE(user_.next());
  listenTo(kTick);
  EXPECT_EQ(host_.next()->address.action, base_action::kRegisterEvent);  // asked anew
}

TEST_F(RoutedService, ItsHostGoingEndsARegistration) {
  listenTo(kTick);
  tellOffer();
  host_.connection.reset();
  EXPECT_EQ(user_.next()->type, MessageType::Error);
}

// Pages and MessagePack clients are told the link by the answer: what comes before waits for it.
TEST_F(RoutedService, ClientsThatGoByNamesHearWhatCameBeforeTheAnswerAfterIt) {
  NamedCalls calls(demo_.hub, "tcp://127.0.0.1:1");
  std::vector<std::string> told;
  const auto subscribed = calls.subscribe(
      "Module", "tick", [&told](std::uint64_t /*link*/, const std::vector<Value>& arguments) {
        told.push_back(arguments[1].print());
      });
  tellOffer();
  const auto listening = host_.next();
  ASSERT_TRUE(listening);
  raise(kTick, Value::tuple({1, "early"}));
  EXPECT_FALSE(subscribed.isDone());
  subscribed.whenDone([&told](const auto& /*outcome*/) { told.push_back("answered"); });
  answer(*listening, std::uint64_t{1});
  raise(kTick, Value::tuple({2, "late"}));
  EXPECT_THAT(told, testing::ElementsAre("answered", "\"early\"", "\"late\""));
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

// What libqi's dynamic signals declare: "m" travels as one dynamic, the tuple of the arguments.
class DynamicSignals : public RoutedService {
 protected:
  static constexpr std::uint32_t kAny = 120;
  static constexpr std::uint32_t kList = 121;
  static constexpr std::uint32_t kOne = 122;

  DynamicSignals() {
    rpc::Service offer("Module", "");
    offer.insert(rpc::SignalMember{kAny, "any", rpc::Emitter("m")});
    offer.insert(rpc::SignalMember{kList, "list", rpc::Emitter("[m]")});
    offer.insert(rpc::SignalMember{kOne, "one", rpc::Emitter("(m)")});
    offer_ = metaObjectOf(offer, false);
  }

  // The user hears of it from now on.
  void hear(std::uint32_t signal, const std::string& wished = {}) {
    if (wished.empty()) {
      listenTo(signal);
    } else {
      user_.call({id_, 1, base_action::kRegisterEventWithSignature},
                 Value::tuple({id_, signal, std::uint64_t{5}, wished}));
    }
    answer(*host_.next(), offer_);
    answer(*host_.next(), std::uint64_t{1});
    user_.received.clear();
  }

  void raiseBytes(std::uint32_t signal, const Value& value, const std::string& as) {
    Message message;
    message.type = MessageType::Event;
    message.address = {id_, 1, signal};
    encode(message.payload, value, Signature::of(as));
    host_.send(message);
  }

  Value offer_;
};

TEST_F(DynamicSignals, AreToldOnAsDeclared) {
  user_.call({id_, 1, base_action::kMetaObject}, Value::tuple({0U}));
  answer(*host_.next(), offer_);
  EXPECT_EQ(user_.nextValue(metaObjectSignature()), offer_);
}

TEST_F(DynamicSignals, CarryAnyNumberOfArguments) {
  hear(kAny);
  for (const Value& arguments :
       {Value::tuple({42, "tick"}), Value::tuple({0.5F}), Value::tuple(std::vector<Value>{})}) {
    raiseBytes(kAny, arguments, "m");
    const auto event = user_.next();
    ASSERT_TRUE(event);
    EXPECT_EQ(Decoder(event->payload).read("m"), arguments);
  }
}

TEST_F(DynamicSignals, OneValueThatIsNoTupleIsTheOneArgument) {
  hear(kAny);
  raiseBytes(kAny, Value::list({1, 2}), "m");
  EXPECT_EQ(user_.nextValue("m"), Value::tuple("([m])", {Value::list({1, 2})}));
}

TEST_F(DynamicSignals, OneNestedTooDeepToBeToldOnIsIgnoredAndHarmsNobody) {
  hear(kAny);
  std::string deepest(rpc::kMaxNesting - 1, '[');
  deepest += "i" + std::string(rpc::kMaxNesting - 1, ']');
  ASSERT_TRUE(Signature::parse("[" + deepest + "]"));
  raiseBytes(kAny, Value::listOf(deepest, {}), "m");
  raiseBytes(kAny, Value::tuple("(m)", {Value::listOf(deepest, {})}), "m");
  EXPECT_FALSE(user_.next());
  EXPECT_FALSE(user_.connection->wantsClose());
  raiseBytes(kAny, Value::tuple({1}), "m");
  EXPECT_EQ(user_.nextValue("m"), Value::tuple({1}));
}

TEST_F(DynamicSignals, ListsStayLists) {
  hear(kList);
  raiseBytes(kList, Value::list({1, "two"}), "[m]");
  EXPECT_EQ(user_.nextValue("[m]"), Value::list({1, "two"}));
}

TEST_F(DynamicSignals, OneArgumentOfAnyTypeKeepsItsType) {
  hear(kOne);
  raiseBytes(kOne, Value::tuple("(m)", {"two"}), "(m)");
  EXPECT_EQ(user_.nextValue("(m)"), Value::tuple("(m)", {"two"}));
}

TEST_F(DynamicSignals, AWishIsMet) {
  hear(kAny, "(ds)");
  raiseBytes(kAny, Value::tuple({42, "tick"}), "m");
  const auto event = user_.next();
  ASSERT_TRUE(event);
  EXPECT_EQ(event->flags, kFlagDynamic);
  EXPECT_EQ(Decoder(event->payload).read("m"), Value::tuple({42.0, "tick"}));
}

TEST_F(DynamicSignals, ClientsMayEmitThem) {
  hear(kAny);
  user_.call({id_, 1, kAny}, Value::tuple({7, "seven"}), kFlagDynamic, MessageType::Post);
  EXPECT_EQ(user_.nextValue("m"), Value::tuple({7, "seven"}));
}

TEST_F(DynamicSignals, SignalsOfTypesThatAreNoArgumentsAreLeftOut) {
  rpc::Service offer("Module", "");
  offer.insert(rpc::SignalMember{kAny, "number", rpc::Emitter("i")});
  user_.call({id_, 1, base_action::kMetaObject}, Value::tuple({0U}));
  answer(*host_.next(), metaObjectOf(offer, false));
  EXPECT_EQ(user_.nextValue(metaObjectSignature()),
            metaObjectOf(rpc::Service("Module", ""), false));
}

}  // namespace
}  // namespace nao::wire
