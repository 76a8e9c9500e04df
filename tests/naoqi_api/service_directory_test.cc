#include "naoqi_api/services/service_directory.h"

#include <gtest/gtest.h>

#include "tests/naoqi_api/test_client.h"

namespace nao::wire {
namespace {

constexpr char kInfo[] =
    "(sIsI[s]s)<ServiceInfo,name,serviceId,machineId,processId,endpoints,sessionId>";

Address directory(std::uint32_t action) { return {1, 1, action}; }

Value infoOf(const std::string& name, std::uint32_t id = 0) {
  return Value::tuple(
      kInfo, {name, id, "machine", 7U, Value::listOf("s", {"tcp://127.0.0.1:1234"}), "session"});
}

class ServiceDirectoryTest : public testing::Test {
 protected:
  ServiceDirectoryTest() {
    client_.authenticate({{"MessageFlags", true}});
    other_.authenticate({{"MessageFlags", true}});
  }

  static Value call(TestClient& client, std::uint32_t action, std::vector<Value> arguments,
                    const std::string& returns) {
    client.call(directory(action), Value::tuple(std::move(arguments)));
    return client.nextValue(returns);
  }
  static std::size_t serviceCount(TestClient& client) {
    return call(client, 101, {}, "[" + std::string(kInfo) + "]").findItems()->size();
  }

  DemoHub demo_;
  TestClient client_{demo_.hub};
  TestClient other_{demo_.hub};
};

TEST_F(ServiceDirectoryTest, ListsEveryServiceAtTheAddressTheClientDialled) {
  const Value all = call(client_, 101, {}, "[" + std::string(kInfo) + "]");
  ASSERT_EQ(all.findItems()->size(), 2U);
  const services::ServiceInfo first = services::serviceInfoOf((*all.findItems())[0]);
  EXPECT_EQ(first.name, "ServiceDirectory");
  EXPECT_EQ(first.service_id, 1U);
  EXPECT_EQ(first.session_id, "0");
  const services::ServiceInfo second = services::serviceInfoOf((*all.findItems())[1]);
  EXPECT_EQ(second.name, "Demo");
  EXPECT_EQ(second.endpoints, std::vector<std::string>{"tcp://127.0.0.1:9559"});
  EXPECT_EQ(second.process_id, 42U);
}

TEST_F(ServiceDirectoryTest, ListsRelativeAddressesToWhoUnderstandsThem) {
  TestClient modern(demo_.hub);
  modern.authenticate();
  const auto info = services::serviceInfoOf(call(modern, 100, {"Demo"}, kInfo));
  EXPECT_EQ(info.endpoints,
            (std::vector<std::string>{"qi:ServiceDirectory", "qi:Demo", "tcp://127.0.0.1:9559"}));
}

TEST_F(ServiceDirectoryTest, GivesTheMachineId) {
  EXPECT_EQ(call(client_, 108, {}, "s"), Value(demo_.hub.options().machine_id));
}

TEST_F(ServiceDirectoryTest, SaysWhatItCanNotFind) {
  EXPECT_EQ(call(client_, 100, {"Nope"}, kInfo), Value("Cannot find service 'Nope' in index"));
  EXPECT_EQ(call(client_, 103, {99U}, "v"), Value("Unregister Service: Can't find service #99"));
}

TEST_F(ServiceDirectoryTest, AServiceIsVisibleOnceReadyAndGoesWithItsClient) {
  const auto id = call(client_, 102, {infoOf("Mine")}, "I").to<std::uint32_t>();
  EXPECT_EQ(serviceCount(other_), 2U);
  call(other_, 0, {1U, 106U, std::uint64_t{1}}, "L");
  call(other_, 0, {1U, 107U, std::uint64_t{2}}, "L");
  call(client_, 104, {id}, "v");
  EXPECT_EQ(other_.nextValue("(Is)"), Value::tuple({id, "Mine"}));  // serviceAdded
  EXPECT_EQ(serviceCount(other_), 3U);
  const auto info = services::serviceInfoOf(call(other_, 100, {"Mine"}, kInfo));
  EXPECT_EQ(info.endpoints, std::vector<std::string>{"tcp://127.0.0.1:1234"});
  EXPECT_EQ(info.service_id, id);
  client_.connection.reset();
  EXPECT_EQ(other_.next()->address.action, 107U);  // serviceRemoved
  EXPECT_EQ(serviceCount(other_), 2U);
}

TEST_F(ServiceDirectoryTest, ATakenNameIsRefused) {
  EXPECT_EQ(call(client_, 102, {infoOf("Demo")}, "I"),
            Value("Service \"Demo\" (#2) is already registered. Rejecting conflicting "
                  "registration attempt."));
}

TEST_F(ServiceDirectoryTest, ClientsManageOnlyTheirOwnServices) {
  const auto id = call(client_, 102, {infoOf("Mine")}, "I").to<std::uint32_t>();
  EXPECT_EQ(call(other_, 103, {id}, "v"),
            Value("Unregister Service: service #3 is not the caller's"));
  EXPECT_EQ(call(other_, 103, {2U}, "v"),
            Value("Unregister Service: service #2 is not the caller's"));
  EXPECT_EQ(call(other_, 104, {id}, "v"), Value("Service Ready: service #3 is not the caller's"));
  EXPECT_EQ(call(client_, 103, {id}, "v"), Value());
}

TEST_F(ServiceDirectoryTest, AClientEntersABoundedNumberOfServices) {
  for (int i = 0; i < 256; ++i) call(client_, 102, {infoOf("s" + std::to_string(i))}, "I");
  EXPECT_EQ(call(client_, 102, {infoOf("more")}, "I"), Value("too many services from one client"));
  EXPECT_EQ(call(other_, 102, {infoOf(std::string(70000, 'x'))}, "I"),
            Value("the ServiceInfo is too large"));
}

TEST(ServiceHub, TellsOfServicesThatComeLater) {
  DemoHub demo;
  TestClient client(demo.hub);
  client.authenticate();
  client.call(directory(0), Value::tuple({1U, 106U, std::uint64_t{1}}));
  client.received.clear();
  EXPECT_EQ(demo.hub.add(rpc::Service("Late", "")), 3U);
  EXPECT_EQ(client.nextValue("(Is)"), Value::tuple({3U, "Late"}));
  demo.hub.remove(3);
  EXPECT_EQ(demo.hub.findService("Late"), nullptr);
}

}  // namespace
}  // namespace nao::wire
