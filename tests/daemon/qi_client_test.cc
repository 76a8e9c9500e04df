#include "daemon/qi_client.h"

#include <gtest/gtest.h>

#include <limits>
#include <thread>

#include "core/check.h"
#include "daemon/daemon.h"
#include "naoqi_api/call_error.h"

namespace nao::daemon {
namespace {

using rpc::Value;

class QiClientTest : public testing::Test {
 protected:
  QiClientTest() : daemon_(options()), thread_([this] { daemon_.run(); }) {}
  ~QiClientTest() override {
    daemon_.stop();
    thread_.join();
  }

  static Options options() {
    Options options;
    options.robots = {{"arm", "arm", {}}};
    options.world = NAO_SOURCE_DIR "/worlds/empty.yaml";
    options.robots_dir = NAO_SOURCE_DIR "/robots";
    options.port = 0;
    options.strict = true;  // as a real robot that asks for authentication
    options.speed = std::numeric_limits<double>::infinity();
    return options;
  }

  Daemon daemon_;
  std::thread thread_;
};

TEST_F(QiClientTest, CallsMethodsByNameAndBendsArguments) {
  QiClient client("127.0.0.1", daemon_.port(0));
  client.call("ALMemory", "insertData", {"Mine", 1.5F});
  const Value values = client.call("ALMemory", "getListData", {Value::listOf("s", {"Mine"})});
  EXPECT_EQ(values.findItems()->at(0).findNumber(), 1.5);
}

TEST_F(QiClientTest, AsksOtherThingsWhileACallIsUnderWay) {
  QiClient client("127.0.0.1", daemon_.port(0));
  client.call("ALMotion", "setStiffnesses", {"ElbowPitch", 1.0F});
  const auto moving =
      client.begin("ALMotion", "angleInterpolation", {"ElbowPitch", 0.25F, 0.5F, true});
  const Value other = client.call("ALMotion", "getStiffnesses", {"ElbowPitch"});
  EXPECT_TRUE(other.findItems());
  client.finish(moving);
  const Value angles = client.call("ALMotion", "getAngles", {"ElbowPitch", false});
  EXPECT_NEAR(*angles.findItems()->at(0).findNumber(), 0.25, 1e-6);
}

TEST_F(QiClientTest, PassesOnWhatTheRobotRefuses) {
  QiClient client("127.0.0.1", daemon_.port(0));
  EXPECT_THROW(client.call("ALMotion", "getAngles", {"Tail", false}), rpc::CallError);
  EXPECT_THROW(client.call("ALMotion", "fly", {}), rpc::CallError);
  EXPECT_THROW(client.call("ALFlight", "fly", {}), rpc::CallError);
}

TEST(QiClient, TellsThatNobodyAnswers) { EXPECT_THROW(QiClient("127.0.0.1", 1), InputError); }

}  // namespace
}  // namespace nao::daemon
