// How a connection begins: with an authentication, or as clients from before 2014 do.

#include <gtest/gtest.h>

#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

constexpr Address kAuthenticate = {0, 0, 8};
constexpr Address kMetaObject = {1, 1, 2};

Message mapMessage(MessageType type, const Address& address) {
  Message message;
  message.id = 1;
  message.type = type;
  message.address = address;
  encode(message.payload, Value::Map{"s", "m", {{"MessageFlags", true}}}, Signature::of("{sm}"));
  return message;
}

Message capabilities() { return mapMessage(MessageType::Capability, {}); }
Message authentication() { return mapMessage(MessageType::Call, kAuthenticate); }

TEST(Opening, AnAuthenticationIsGrantedWithOurCapabilities) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.send(authentication());
  const auto map = client.nextValue("{sm}").to<std::map<std::string, Value>>();
  EXPECT_EQ(map.at("__qi_auth_state"), Value(3U));
  EXPECT_EQ(map.at("MetaObjectCache"), Value(false));
  EXPECT_EQ(map.at("ClientServerSocket"), Value(true));
  EXPECT_TRUE(client.connection->isOpen());
}

TEST(Opening, ASecondAuthenticationIsToldOnlyTheState) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.send(authentication());
  client.received.clear();
  client.send(authentication());
  EXPECT_EQ(client.nextValue("{sm}"), Value(Value::Map{"s", "m", {{"__qi_auth_state", 3U}}}));
}

TEST(Opening, AnOlderClientTellsItsCapabilitiesAndIsToldOurs) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.send(capabilities());
  const auto answer = client.next();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->type, MessageType::Capability);
  EXPECT_EQ(answer->address.service, 0U);
  EXPECT_EQ(Decoder(answer->payload).read("{sm}").find<Value::Map>()->entries.size(), 6U);
  client.call(kMetaObject, Value::tuple({0U}));
  EXPECT_EQ(client.next()->type, MessageType::Reply);
}

TEST(Opening, AnOlderClientMayCallAtOnce) {
  DemoHub demo;
  TestClient client(demo.hub);
  const auto id = client.call(kMetaObject, Value::tuple({0U}));
  EXPECT_EQ(client.next()->type, MessageType::Capability);
  const auto reply = client.next();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->type, MessageType::Reply);
  EXPECT_EQ(reply->id, id);
}

TEST(Opening, OurCapabilitiesAreSentOnce) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.send(capabilities());
  client.send(capabilities());
  EXPECT_EQ(client.received.size(), 1U);
}

TEST(Opening, AnOlderClientGetsTheSixFieldServiceInfo) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.send(capabilities());
  client.received.clear();
  client.call({1, 1, 100}, Value::tuple({"Demo"}));
  const Value info = client.nextValue(
      "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>");
  EXPECT_EQ((*info.findItems())[4], Value::listOf("s", {"tcp://127.0.0.1:9559"}));
}

TEST(Opening, TheStrictPersonalityRefusesUntilAuthenticated) {
  DemoHub demo(rpc::Personality::libqi4());
  TestClient client(demo.hub);
  client.send(capabilities());
  EXPECT_FALSE(client.next());
  client.call(kMetaObject, Value::tuple({0U}));
  EXPECT_EQ(client.nextValue("m"), Value("The call request could not be handled."));
  client.call({2, 1, 103}, Value::tuple({}), 0, MessageType::Post);
  EXPECT_FALSE(client.next());
  EXPECT_EQ(demo.demo.calls_of_nothing, 0);
  client.send(authentication());
  EXPECT_EQ(client.next()->type, MessageType::Reply);
  client.call(kMetaObject, Value::tuple({0U}));
  EXPECT_EQ(client.next()->type, MessageType::Reply);
}

TEST(Opening, AMalformedAuthenticationEndsTheConnection) {
  DemoHub demo;
  TestClient client(demo.hub);
  Message message = authentication();
  message.payload = {5, 0, 0, 0};
  client.send(message);
  EXPECT_EQ(client.next()->type, MessageType::Error);
  EXPECT_TRUE(client.connection->wantsClose());
  client.send(authentication());
  EXPECT_FALSE(client.next());
}

TEST(Opening, BeforeItPayloadsAreSmall) {
  DemoHub demo;
  Message message;
  message.address = kMetaObject;
  message.payload.resize(kMaxPayloadBefore + 1);
  TestClient fresh(demo.hub);
  fresh.send(message);
  EXPECT_TRUE(fresh.connection->wantsClose());
  EXPECT_FALSE(fresh.next());
  TestClient open(demo.hub);
  open.authenticate();
  open.send(message);
  EXPECT_FALSE(open.connection->wantsClose());
  EXPECT_TRUE(open.next());
}

TEST(Opening, WhatIsNoQiIsNotAnswered) {
  DemoHub demo;
  TestClient client(demo.hub);
  const std::string request = "GET / HTTP/1.1\r\n\r\n";
  client.sendBytes(Bytes(request.begin(), request.end()));
  EXPECT_FALSE(client.next());
  EXPECT_TRUE(client.connection->wantsClose());
}

TEST(Opening, BytesMayComeOneByOne) {
  DemoHub demo;
  TestClient client(demo.hub);
  for (std::uint8_t byte : encodeFrame(authentication())) client.sendBytes({byte});
  EXPECT_EQ(client.received.size(), 1U);
}

}  // namespace
}  // namespace nao::wire
