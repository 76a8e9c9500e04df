// The whole daemon on loopback: the one place where tests use sockets.
#include <gtest/gtest.h>

#include <future>
#include <limits>
#include <thread>

#include "core/check.h"
#include "core/random.h"
#include "tests/daemon/running_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;

class ServerTest : public testing::Test {
 protected:
  double simulatedTime(TcpClient& client) {
    const std::uint32_t usar_sim = client.service("UsarSim");
    return *client.answer(client.call({usar_sim, 1, 105}, Value::tuple({})), "d").find<double>();
  }

  /// A well-behaved client is served, and time goes on.
  void expectWell() {
    TcpClient client(running_.port());
    const double before = simulatedTime(client);
    while (simulatedTime(client) <= before) {
    }
  }

  Running running_{optionsFor({{"nao", "nao_h21_v33", {}}})};
};

TEST_F(ServerTest, ServesAClient) { expectWell(); }

TEST_F(ServerTest, ClosesOnGarbageAndServesTheNext) {
  TcpClient client(running_.port());
  client.sendBytes(wire::Bytes(100, 'x'));
  EXPECT_FALSE(client.receive());
  expectWell();
}

TEST_F(ServerTest, ClosesOnAMessageThatIsTooLarge) {
  TcpClient client(running_.port());
  wire::Message message;
  wire::Bytes frame = encodeFrame(message);
  frame[11] = 0x7f;  // the size's highest byte: 2 GB
  client.sendBytes(frame);
  EXPECT_FALSE(client.receive());
  expectWell();
}

TEST_F(ServerTest, SurvivesClientsThatVanish) {
  for (int k = 0; k < 20; ++k) {
    TcpClient client(running_.port());
    const std::uint32_t motion = client.service("ALMotion");
    client.call({motion, 1, 113}, Value::tuple({}));  // wakeUp, which takes seconds
    if (k % 2) client.sendBytes(wire::Bytes{0x42, 0xde, 0xad});
    client.shutDown();
  }
  expectWell();
}

TEST_F(ServerTest, AClientThatDoesNotReadHarmsNobody) {
  TcpClient deaf(running_.port());
  wire::Bytes calls;
  for (std::uint32_t id = 1; id <= 2000; ++id) {  // each answered with some kilobytes
    wire::Message message;
    message.id = id;
    message.address = {1, 1, 2};
    wire::encode(message.payload, Value::tuple({0U}), rpc::Signature::of("(I)"));
    const wire::Bytes frame = encodeFrame(message);
    calls.insert(calls.end(), frame.begin(), frame.end());
  }
  // Above 1 MiB unsent it is no longer read: what it sends beyond that waits in the sockets.
  for (int k = 0; k < 3; ++k) {
    if (!deaf.trySendBytes(calls)) break;
  }
  expectWell();
}

TEST_F(ServerTest, AnswersManyLargeCallsThatCameTogether) {
  constexpr std::uint32_t kCalls = 2000;  // metaobjects of some kilobytes: well over 8 MiB
  TcpClient client(running_.port());
  const std::uint32_t motion = client.service("ALMotion");
  wire::Bytes calls;
  for (std::uint32_t id = 1; id <= kCalls; ++id) {
    wire::Message message;
    message.id = 1000 + id;
    message.address = {motion, 1, 2};
    wire::encode(message.payload, Value::tuple({0U}), rpc::Signature::of("(I)"));
    const wire::Bytes frame = encodeFrame(message);
    calls.insert(calls.end(), frame.begin(), frame.end());
  }
  client.sendBytes(calls);
  std::size_t bytes = 0;
  for (std::uint32_t id = 1; id <= kCalls; ++id) {
    const auto answer = client.receive();
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->id, 1000 + id);
    bytes += answer->payload.size();
  }
  EXPECT_GT(bytes, 2 * Session::kGiveUp);
}

TEST_F(ServerTest, AnswersManyCallsThatEndTogether) {
  constexpr int kCalls = 20;  // pictures of 0.9 MB: over 8 MiB at once
  TcpClient client(running_.port());
  const std::uint32_t video = client.service("ALVideoDevice");
  const std::uint32_t get_image = client.method(video, "getImageRemote");
  const auto subscribed = client.call({video, 1, client.method(video, "subscribeCamera")},
                                      Value::tuple({"test", 0, 2, 11, 5}));
  const Value handle = client.answer(subscribed, "s");
  std::vector<std::uint32_t> asked;
  for (int k = 0; k < kCalls; ++k) {
    asked.push_back(client.call({video, 1, get_image}, Value::tuple({handle})));
  }
  for (const std::uint32_t id : asked) {
    const Value image = client.answer(id, "m");
    ASSERT_NE(image.findItems(), nullptr);
    EXPECT_EQ(image.findItems()->at(6).findBytes()->size(), 640U * 480U * 3U);
  }
}

TEST_F(ServerTest, AWaitForAPostedCallHasATimeOut) {
  constexpr std::uint32_t kPost = 101;
  constexpr std::uint32_t kWait = 108;
  constexpr std::uint32_t kAngleInterpolation = 127;
  TcpClient client(running_.port());
  const std::uint32_t motion = client.service("ALMotion");
  const Value endless = Value::list({"HeadYaw", 0.1F, 1e6F, true});
  const auto posted = client.call({motion, 1, kPost}, Value::tuple({kAngleInterpolation, endless}));
  const int task = client.answer(posted, "i").to<int>();
  const auto waited = client.call({motion, 1, kWait}, Value::tuple({task, 500}));
  EXPECT_EQ(client.answer(waited, "b"), Value(true));  // the time-out came first
}

/// The simulator's service as a client calls it.
class UsarSimClient {
 public:
  explicit UsarSimClient(TcpClient& client) : client_(client), id_(client.service("UsarSim")) {}
  Value ask(const char* method, const std::vector<Value>& arguments, const char* returns) {
    const auto call = client_.call({id_, 1, client_.method(id_, method)}, Value::tuple(arguments));
    return client_.answer(call, returns);
  }

 private:
  TcpClient& client_;
  std::uint32_t id_;
};

TEST_F(ServerTest, AClientTakesASnapshotMovesAndGoesBack) {
  TcpClient client(running_.port());
  UsarSimClient usar_sim(client);
  const std::uint32_t motion = client.service("ALMotion");
  const std::uint32_t wake_up = client.method(motion, "wakeUp");
  usar_sim.ask("pause", {}, "v");
  usar_sim.ask("snapshot", {"limp"}, "v");
  const Value time = usar_sim.ask("time", {}, "d");
  const Value limp = usar_sim.ask("hash", {}, "s");

  Value moved[2];
  for (Value& hash : moved) {
    const auto waking = client.call({motion, 1, wake_up}, Value::tuple({}));
    usar_sim.ask("step", {std::int64_t{500}}, "v");  // 1 s: less than it needs
    hash = usar_sim.ask("hash", {}, "s");
    EXPECT_NE(hash, limp);
    const auto restore = client.service("UsarSim");
    const auto back =
        client.call({restore, 1, client.method(restore, "restore")}, Value::tuple({"limp"}));
    const Value failure = client.answer(waking, "v");
    EXPECT_EQ(*failure.findText(),
              "\tALMotion::wakeUp\n\tthe simulation was set back to a snapshot");
    client.answer(back, "v");
    EXPECT_EQ(usar_sim.ask("time", {}, "d"), time);
    EXPECT_EQ(usar_sim.ask("hash", {}, "s"), limp);
  }
  EXPECT_EQ(moved[0], moved[1]);

  EXPECT_EQ(usar_sim.ask("snapshots", {}, "[s]").to<std::vector<std::string>>(),
            std::vector<std::string>{"limp"});
  usar_sim.ask("dropSnapshot", {"limp"}, "v");
  EXPECT_EQ(*usar_sim.ask("restore", {"limp"}, "v").findText(),
            "UsarSim: there is no snapshot 'limp'");
  EXPECT_NE(usar_sim.ask("snapshot", {std::string(101, 'x')}, "v").findText(), nullptr);
}

TEST_F(ServerTest, APressIsSeenByAlMemoryWhileItLasts) {
  TcpClient client(running_.port());
  UsarSimClient usar_sim(client);
  const std::uint32_t memory = client.service("ALMemory");
  const std::uint32_t get_data = client.method(memory, "getData");
  const auto read = [&](const std::string& key) {
    return client.answer(client.call({memory, 1, get_data}, Value::tuple({key})), "m").to<float>();
  };
  const std::string devices = "Device/SubDeviceList/";
  for (const std::string sensor : {"ChestBoard/Button", "Head/Touch/Front", "LFoot/Bumper/Left"}) {
    const std::string key = devices + sensor + "/Sensor/Value";
    usar_sim.ask("pause", {}, "v");
    usar_sim.ask("press", {sensor, 0.1}, "v");
    usar_sim.ask("step", {std::int64_t{20}}, "v");  // 40 ms
    EXPECT_EQ(read(key), 1) << key;
    usar_sim.ask("step", {std::int64_t{50}}, "v");
    EXPECT_EQ(read(key), 0) << key;
  }
  const Value error = usar_sim.ask("press", {"LHand/Touch/Back", 0.1}, "v");  // an H21
  ASSERT_NE(error.findText(), nullptr);
  EXPECT_NE(error.findText()->find("Head/Touch/Front"), std::string::npos) << *error.findText();
}

TEST(Daemon, SaysWhatItsSeedHasDrawn) {
  Options options = optionsFor({{"nao", "nao_h21_v33", {}}});
  options.seed = 7;
  Running running(options);
  TcpClient client(running.port());
  UsarSimClient usar_sim(client);
  EXPECT_EQ(usar_sim.ask("seed", {}, "L").to<std::int64_t>(), 7);
  const Value draw = usar_sim.ask("draw", {}, "{sd}");
  ASSERT_NE(draw.find<Value::Map>(), nullptr);
  EXPECT_GT(draw.find<Value::Map>()->entries.size(),
            20U);  // a zero of every joint, the floor, the start
}

TEST_F(ServerTest, MutatedFramesNeverStopIt) {
  Random random(5);
  for (int k = 0; k < 100; ++k) {
    TcpClient client(running_.port());
    wire::Message message;
    message.id = 1;
    message.address = {static_cast<std::uint32_t>(random.uniform(0, 6)),
                       static_cast<std::uint32_t>(random.uniform(0, 3)),
                       static_cast<std::uint32_t>(random.uniform(0, 300))};
    message.payload.resize(static_cast<std::size_t>(random.uniform(0, 64)));
    for (auto& byte : message.payload) byte = static_cast<std::uint8_t>(random.uniform(0, 256));
    client.trySendBytes(encodeFrame(message));
  }
  expectWell();
}

TEST(Daemon, RobotsListenOnTheirOwnPorts) {
  Running running(optionsFor({{"a", "nao_h21_v33", {}}, {"b", "nao_h25_v50", {}}}));
  EXPECT_NE(running.port(0), running.port(1));
  for (std::size_t i = 0; i < 2; ++i) {
    TcpClient client(running.port(i));
    const std::uint32_t motion = client.service("ALMotion");
    const auto id = client.call({motion, 1, 255}, Value::tuple({"Body"}));
    const Value names = client.answer(id, "[s]");
    ASSERT_NE(names.findItems(), nullptr);
    EXPECT_EQ(names.findItems()->size(), i == 0 ? 22U : 26U);  // H21, H25
  }
}

TEST(Daemon, SaysThatAPortIsTaken) {
  Running running(optionsFor({{"nao", "nao_h21_v33", {}}}));
  Options options = optionsFor({{"other", "nao_h21_v33", {}}});
  options.port = running.port();
  try {
    Daemon second(options);
    FAIL() << "two daemons on one port";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(std::to_string(running.port())), std::string::npos);
  }
}

TEST(Daemon, RefusesTwoRobotsOfOneName) {
  EXPECT_THROW(Daemon(optionsFor({{"a", "nao_h21_v33", {}}, {"a", "nao_h21_v33", {}}})),
               InputError);
}

TEST(Daemon, AStrictOneRefusesCallsBeforeAuthentication) {
  Options options = optionsFor({{"nao", "nao_h21_v33", {}}});
  options.strict = true;
  Running running(options);
  TcpClient client(running.port());
  const auto answer = client.answer(client.call({1, 1, 2}, Value::tuple({0U})), "m");
  EXPECT_NE(answer.find<std::string>(), nullptr);
}

}  // namespace
}  // namespace nao::daemon
