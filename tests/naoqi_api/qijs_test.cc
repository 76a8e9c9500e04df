#include <gtest/gtest.h>

#include <cmath>

#include "naoqi_api/wire/qijs_connection.h"
#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

std::string jsonOf(const Value& value) {
  const NameOf none = [](const ObjectRef& /*object*/) { return "null"; };
  JsonWriter writer(none);
  writer.write(value);
  return writer.json();
}

TEST(JsonCodec, ReadsWhatPagesSend) {
  EXPECT_EQ(readJson("[1,-2,0.5,true,null,\"x\"]"), Value::list({1, -2, 0.5, true, Value(), "x"}));
  EXPECT_EQ(readJson("{\"a\":1}"), Value(Value::Map{"s", "m", {{"a", 1}}}));
  EXPECT_EQ(readJson("4294967296"), Value(std::int64_t{1} << 32U));
  for (const char* bad : {"", "{", "[1,]", "nul", "1 2", "{\"a\"}", "NaN"}) {
    EXPECT_FALSE(readJson(bad)) << bad;
  }
  EXPECT_FALSE(readJson(std::string(100, '[') + std::string(100, ']')));
  EXPECT_FALSE(readJson(std::string(1000000, '[')));
}

TEST(JsonCodec, WritesEveryKind) {
  EXPECT_EQ(jsonOf(Value::list({1, 0.5, true, Value(), "a\"b", std::int8_t{-3}})),
            "[1,0.5,true,null,\"a\\\"b\",-3]");
  EXPECT_EQ(jsonOf(Value::tuple({1, "x"})), "[1,\"x\"]");
  EXPECT_EQ(jsonOf(Value::raw({1, 255})), "[1,255]");
  EXPECT_EQ(jsonOf(Value::Map{"s", "i", {{"a", 1}, {"b", 2}}}), "{\"a\":1,\"b\":2}");
  EXPECT_EQ(jsonOf("\xff"), "\"\xef\xbf\xbd\"");
  EXPECT_THROW(jsonOf(std::nan("")), rpc::CallError);
}

class QijsTest : public testing::Test {
 protected:
  // Sends a call as a page does.
  std::string ask(const std::string& object, const std::string& member,
                  const std::string& arguments) {
    EXPECT_TRUE(connection_->receive(
        "5:::{\"name\":\"call\",\"args\":[{\"idm\":7,\"params\":{"
        "\"obj\":" +
        object + ",\"member\":\"" + member + "\",\"args\":" + arguments + "}}]}"));
    return next();
  }
  std::string next() {
    if (received_.empty()) return "nothing came";
    const std::string text = received_.front();
    received_.erase(received_.begin());
    return text;
  }
  static std::string reply(const std::string& result) {
    return "5:::{\"name\":\"reply\",\"args\":[{\"result\":" + result + ",\"idm\":7}]}";
  }
  static std::string error(const std::string& result) {
    return "5:::{\"name\":\"error\",\"args\":[{\"result\":" + result + ",\"idm\":7}]}";
  }
  void getDemo() { ask("\"ServiceDirectory\"", "service", "[\"Demo\"]"); }

  DemoHub demo_;
  std::vector<std::string> received_;
  std::unique_ptr<QijsConnection> connection_ = std::make_unique<QijsConnection>(
      demo_.hub, "tcp://127.0.0.1:1",
      [this](std::string text) { received_.push_back(std::move(text)); }, [] {});

  QijsTest() { EXPECT_EQ(next(), "1::"); }
};

TEST_F(QijsTest, AServiceComesAsAnObjectWithItsMembers) {
  const std::string service = ask("\"ServiceDirectory\"", "service", "[\"Demo\"]");
  EXPECT_EQ(service.rfind("5:::{\"name\":\"reply\",\"args\":[{\"result\":{\"pyobject\":0,"
                          "\"metaobject\":{\"methods\":{",
                          0),
            0U)
      << service.substr(0, 200);
  EXPECT_NE(service.find("\"100\":{\"uid\":100,\"returnSignature\":\"s\",\"name\":\"say\","
                         "\"parametersSignature\":\"(s)\""),
            std::string::npos);
  EXPECT_NE(service.find("\"signals\":{"), std::string::npos);
  EXPECT_TRUE(readJson(service.substr(4)));
  EXPECT_EQ(ask("\"ServiceDirectory\"", "service", "[\"Nope\"]"), reply("null"));
}

TEST_F(QijsTest, MethodsAreCalledOnIt) {
  getDemo();
  EXPECT_EQ(ask("0", "say", "[\"js\"]"), reply("\"hello js\""));
  EXPECT_EQ(ask("0", "add", "[1,2]"), reply("3"));
  EXPECT_EQ(ask("0", "fail", "[]"), error("\"deliberate failure\""));
  EXPECT_EQ(ask("5", "say", "[\"js\"]"), error("\"Cannot find service '#5' in index\""));
}

TEST_F(QijsTest, SignalsAreConnectedAndDisconnected) {
  getDemo();
  EXPECT_EQ(ask("0", "tick", "[\"connect\"]"), reply("1"));
  demo_.demo.tick(42, "x");
  EXPECT_EQ(next(),
            "5:::{\"name\":\"signal\",\"args\":[{\"result\":{\"obj\":0,\"signal\":\"tick\","
            "\"data\":[42,\"x\"],\"link\":1}}]}");
  EXPECT_EQ(ask("0", "tick", "[\"disconnect\",1]"), reply("null"));
  demo_.demo.tick(43, "x");
  EXPECT_EQ(next(), "nothing came");
}

TEST_F(QijsTest, PropertiesAreReadAndSet) {
  getDemo();
  EXPECT_EQ(ask("0", "level", "[\"value\"]"), reply("0.5"));
  EXPECT_EQ(ask("0", "level", "[\"setValue\",0.75]"), reply("null"));
  EXPECT_EQ(demo_.demo.level.get(), 0.75F);
  EXPECT_EQ(ask("0", "level", "[\"setValue\",1]"), reply("null"));
  EXPECT_EQ(demo_.demo.level.get(), 1.0F);
}

TEST_F(QijsTest, TheFormerProtocolRegistersEvents) {
  getDemo();
  EXPECT_TRUE(connection_->receive(
      "5:::{\"name\":\"call\",\"args\":[{\"idm\":7,\"params\":{\"obj\":0,\"method\":"
      "\"registerEvent\",\"args\":[\"tick\"]}}]}"));
  EXPECT_EQ(next(), reply("1"));
  demo_.demo.tick(1, "x");
  EXPECT_NE(next().find("\"signal\":\"tick\""), std::string::npos);
}

TEST_F(QijsTest, HeartbeatsAreAnsweredAndGarbageCloses) {
  EXPECT_TRUE(connection_->receive("2::"));
  EXPECT_EQ(next(), "2::");
  for (const char* bad : {"", "0::", "7", "5:::", "5:::{}", "5:::{\"name\":\"call\"}", "5:x"}) {
    EXPECT_FALSE(connection_->receive(bad)) << bad;
  }
}

TEST_F(QijsTest, APageThatVanishesIsForgotten) {
  getDemo();
  ask("0", "tick", "[\"connect\"]");
  ask("0", "slow", "[5]");
  connection_.reset();
  demo_.demo.finishSlowCalls();
  EXPECT_EQ(demo_.demo.tick.emitter().listenerCount(), 0U);
}

}  // namespace
}  // namespace nao::wire
