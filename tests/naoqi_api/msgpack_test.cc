#include <gtest/gtest.h>

#include "naoqi_api/wire/msgpack_connection.h"
#include "tests/naoqi_api/demo_service.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

Bytes fromHex(const std::string& text) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 3) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::optional<Value> decoded(const Bytes& bytes) {
  MsgpackReader reader;
  reader.push(bytes.data(), bytes.size());
  return reader.next();
}

Bytes packed(const Value& value) {
  Bytes bytes;
  packValue(bytes, value, [](const ObjectRef& /*object*/) { return "#7"; });
  return bytes;
}

TEST(MsgpackCodec, ReadsTheFormatsOfTheSpecification) {
  EXPECT_EQ(decoded(fromHex("c0")), Value());
  EXPECT_EQ(decoded(fromHex("c3")), Value(true));
  EXPECT_EQ(decoded(fromHex("07")), Value(7));
  EXPECT_EQ(decoded(fromHex("ff")), Value(-1));
  EXPECT_EQ(decoded(fromHex("cd 01 00")), Value(256));
  EXPECT_EQ(decoded(fromHex("cf 00 00 00 01 00 00 00 00")), Value(std::int64_t{1} << 32U));
  EXPECT_EQ(decoded(fromHex("cf ff ff ff ff ff ff ff ff")), Value(~std::uint64_t{0}));
  EXPECT_EQ(decoded(fromHex("ca 3f 00 00 00")), Value(0.5F));
  EXPECT_EQ(decoded(fromHex("cb 3f e0 00 00 00 00 00 00")), Value(0.5));
  EXPECT_EQ(decoded(fromHex("a2 68 69")), Value("hi"));
  EXPECT_EQ(*decoded(fromHex("c4 02 01 02"))->findBytes(), (Bytes{1, 2}));
  EXPECT_EQ(decoded(fromHex("92 01 a1 78")), Value::list({1, "x"}));
  EXPECT_EQ(decoded(fromHex("81 a1 78 01")), Value(Value::Map{"m", "m", {{"x", 1}}}));
}

TEST(MsgpackCodec, WritesWhatItReads) {
  const Value all =
      Value::list({1, -5, 0.5F, 0.25, true, "text", Value(), Value::list({Value::list({})})});
  EXPECT_EQ(decoded(packed(all)), all);
  EXPECT_EQ(decoded(packed(Value::tuple({1, "x"}))), Value::list({1, "x"}));
  EXPECT_EQ(decoded(packed(ObjectRef())), Value("#7"));
  EXPECT_EQ(*decoded(packed(Value::raw({1, 2})))->findBytes(), (Bytes{1, 2}));
}

TEST(MsgpackCodec, WaitsForTheRest) {
  const Bytes bytes = packed(Value::list({"hello", 1.5, Value::list({1, 2, 3})}));
  MsgpackReader reader;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_FALSE(reader.next());
    reader.push(&bytes[i], 1);
    if (i + 1 < bytes.size()) {
      EXPECT_FALSE(reader.next());
      EXPECT_GT(reader.bytesHeld(), 0U);
    }
  }
  EXPECT_TRUE(reader.next());
  EXPECT_EQ(reader.bytesHeld(), 0U);
}

TEST(MsgpackCodec, RefusesWhatIsTooDeepTooLargeOrUnknown) {
  for (const Bytes& bytes : {Bytes(100, 0x91), fromHex("c1"), fromHex("d4 01 00")}) {
    MsgpackReader reader;
    reader.push(bytes.data(), bytes.size());
    EXPECT_FALSE(reader.next());
    EXPECT_TRUE(reader.isBroken());
  }
  MsgpackReader reader;
  reader.setMaxBytes(1000);
  const Bytes start = fromHex("db ff ff ff ff");  // a text of 4 GB
  reader.push(start.data(), start.size());
  EXPECT_FALSE(reader.next());
  const Bytes much(2000, 'x');
  reader.push(much.data(), much.size());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.isBroken());
}

class MsgpackConnectionTest : public testing::Test {
 protected:
  void send(const Value& message) {
    const Bytes bytes = packed(message);
    connection_->receive(bytes.data(), bytes.size());
  }
  // The error and the result of what comes back for a request, which has its number.
  Value ask(const std::string& method, std::vector<Value> arguments) {
    send(Value::list({0, ++id_, method, Value::list(std::move(arguments))}));
    const Value answer = next();
    const auto* items = answer.findItems();
    if (!items || items->size() != 4) return answer;
    EXPECT_EQ((*items)[0], Value(1));
    EXPECT_EQ((*items)[1], Value(id_));
    return Value::list({(*items)[2], (*items)[3]});
  }
  Value next() {
    const auto message = reader_.next();
    return message ? *message : Value("nothing came");
  }
  static Value reply(const Value& result) { return Value::list({Value(), result}); }
  static Value error(const std::string& text) { return Value::list({text, Value()}); }

  DemoHub demo_;
  MsgpackReader reader_;
  int id_ = 0;
  std::unique_ptr<MsgpackConnection> connection_ = std::make_unique<MsgpackConnection>(
      demo_.hub, "tcp://127.0.0.1:1",
      [this](const Bytes& bytes) { reader_.push(bytes.data(), bytes.size()); });
};

TEST_F(MsgpackConnectionTest, CallsMethodsByName) {
  EXPECT_EQ(ask("Demo.add", {1, 2}), reply(3));
  EXPECT_EQ(ask("Demo.say", {"you"}), reply("hello you"));
  EXPECT_EQ(ask("Demo.nothing", {}), reply(Value()));
  EXPECT_EQ(ask("Demo.raw", {}).findItems()->at(1).findBytes()->size(), 4U);
  EXPECT_EQ(ask("Demo.getAngles", {Value::list({"a", "b"}), true}),
            reply(Value::list({0.25F, 0.25F})));
  EXPECT_EQ(ask("Demo.fail", {}), error("deliberate failure"));
  EXPECT_EQ(ask("Nope.add", {}), error("Cannot find service 'Nope' in index"));
}

TEST_F(MsgpackConnectionTest, ListsServicesAndMethods) {
  EXPECT_EQ(ask("services", {}), reply(Value::list({"ServiceDirectory", "Demo"})));
  const Value methods = ask("methods", {"Demo"});
  EXPECT_EQ(methods.findItems()->at(1).findItems()->at(0), Value("say"));
}

TEST_F(MsgpackConnectionTest, NotificationsAreNotAnswered) {
  send(Value::list({2, "Demo.nothing", Value::list({})}));
  EXPECT_EQ(demo_.demo.calls_of_nothing, 1);
  EXPECT_EQ(next(), Value("nothing came"));
}

TEST_F(MsgpackConnectionTest, SignalsComeAsNotifications) {
  const Value link = ask("subscribe", {"Demo.tick"});
  demo_.demo.tick(7, "seven");
  EXPECT_EQ(next(), Value::list({2, "Demo.tick", Value::list({7, "seven"})}));
  EXPECT_EQ(ask("unsubscribe", {link.findItems()->at(1)}), reply(Value()));
  demo_.demo.tick(8, "eight");
  EXPECT_EQ(next(), Value("nothing came"));
}

TEST_F(MsgpackConnectionTest, PropertiesAreReadAndSet) {
  EXPECT_EQ(ask("property", {"Demo.level"}), reply(0.5F));
  EXPECT_EQ(ask("setProperty", {"Demo.level", 1}), reply(Value()));
  EXPECT_EQ(demo_.demo.level.get(), 1.0F);
}

TEST_F(MsgpackConnectionTest, ObjectsAreCalledByTheirNames) {
  EXPECT_EQ(ask("Demo.helper", {}), reply("#0"));
  EXPECT_EQ(ask("#0.who", {}), reply("helper"));
  EXPECT_EQ(ask("release", {"#0"}), reply(Value()));
  EXPECT_TRUE(demo_.demo.last_helper.expired());
  EXPECT_EQ(ask("#0.who", {}), error("Cannot find service '#0' in index"));
}

TEST_F(MsgpackConnectionTest, APendingCallNeverBlocksTheNext) {
  EXPECT_EQ(ask("Demo.slow", {5}), Value("nothing came"));
  EXPECT_EQ(ask("Demo.add", {1, 2}), reply(3));
  demo_.demo.finishSlowCalls();
  EXPECT_EQ(next(), Value::list({1, 1, Value(), 5}));
}

TEST_F(MsgpackConnectionTest, WhatIsNoRequestCloses) {
  send(Value::list({7, 1, 2}));
  EXPECT_TRUE(connection_->wantsClose());
}

TEST_F(MsgpackConnectionTest, AClientThatVanishesIsForgotten) {
  ask("subscribe", {"Demo.tick"});
  ask("Demo.slow", {5});
  connection_.reset();
  demo_.demo.tick(7, "seven");
  demo_.demo.finishSlowCalls();
  EXPECT_EQ(demo_.demo.tick.emitter().listenerCount(), 0U);
}

}  // namespace
}  // namespace nao::wire
