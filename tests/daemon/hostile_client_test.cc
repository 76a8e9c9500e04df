// Clients that mean ill: an error or a closed connection for them, nothing for the others.
#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <memory>

#include "daemon/descriptor_limit.h"
#include "naoqi_api/wire/bytes.h"
#include "tests/daemon/running_daemon.h"
#include "tests/daemon/tcp_client.h"

namespace nao::daemon {
namespace {

using rpc::Value;

std::size_t residentBytes() {
  std::size_t total = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * 4096;
}

/// A bare socket: thousands of them fit into one process.
class BareSocket {
 public:
  explicit BareSocket(std::uint16_t port) : descriptor_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{20, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    if (::connect(descriptor_, reinterpret_cast<sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error("connect");
    }
  }
  BareSocket(const BareSocket&) = delete;
  BareSocket& operator=(const BareSocket&) = delete;
  ~BareSocket() { ::close(descriptor_); }

  void send(const wire::Bytes& bytes) const {
    (void)::send(descriptor_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }
  /// Whether the other side has closed, after whatever it still had to say. With MSG_DONTWAIT in
  /// `flags`: already; with 0 it is waited for.
  bool isClosed(int flags) const {
    char buffer[4096];
    ssize_t count = 0;
    do {
      count = ::recv(descriptor_, buffer, sizeof buffer, flags);
    } while (count > 0);
    return count == 0 || errno == ECONNRESET;
  }

 private:
  int descriptor_;
};

wire::Bytes callFrame(const wire::Address& address, const Value& arguments) {
  wire::Message message;
  message.id = 1;
  message.address = address;
  wire::encode(message.payload, arguments, rpc::Signature::of(arguments.signature()));
  return encodeFrame(message);
}

class HostileClient : public testing::Test {
 protected:
  static void SetUpTestSuite() { raiseDescriptorLimit(); }

  static double simulatedTime(TcpClient& client) {
    const std::uint32_t usar_sim = client.service("UsarSim");
    const std::uint32_t time = client.method(usar_sim, "time");
    return *client.answer(client.call({usar_sim, 1, time}, Value::tuple({})), "d").find<double>();
  }

  // Someone who was there before and someone who comes are served, and time goes on.
  void expectWell() {
    const double before = simulatedTime(witness_);
    TcpClient another(running_.port());
    while (simulatedTime(another) <= before) {
    }
  }

  Running running_{optionsForOne()};
  TcpClient witness_{running_.port()};
};

TEST_F(HostileClient, FiveThousandSilentConnectionsLockNobodyOut) {
  expectWell();
  const std::size_t before = residentBytes();
  std::vector<std::unique_ptr<BareSocket>> silent;
  for (int k = 0; k < 5000; ++k) silent.push_back(std::make_unique<BareSocket>(running_.port()));
  expectWell();
  EXPECT_LT(residentBytes(), before + (64U << 20U));
  EXPECT_TRUE(silent.front()->isClosed(0));
}

TEST_F(HostileClient, FiveThousandOpenConnectionsHarmNoneThatWasThere) {
  expectWell();
  const wire::Bytes hello = callFrame({1, 1, 108}, Value::tuple({}));
  std::vector<std::unique_ptr<BareSocket>> open;
  for (int k = 0; k < 5000; ++k) {
    open.push_back(std::make_unique<BareSocket>(running_.port()));
    open.back()->send(hello);
    // One that is silent for a minute may have to give way; on a loaded machine this takes longer.
    if (k % 500 == 0) simulatedTime(witness_);
  }
  const auto served = [&open] {
    return std::count_if(open.begin(), open.end(),
                         [](const auto& socket) { return !socket->isClosed(MSG_DONTWAIT); });
  };
  while (served() >= static_cast<int>(Server::kMostConnections)) simulatedTime(witness_);
  open.clear();
  simulatedTime(witness_);
}

TEST_F(HostileClient, OneThatNeverReadsItsEventsIsClosed) {
  TcpClient deaf(running_.port());
  const std::uint32_t memory = deaf.service("ALMemory");
  const std::uint32_t raise = deaf.method(memory, "raiseEvent");
  const std::uint32_t subscriber = deaf.method(memory, "subscriber");
  // Listens to what it makes others raise: each event is a kilobyte, on a thousand links.
  deaf.call({memory, 1, subscriber}, Value::tuple({"Noise"}));
  const auto answer = deaf.receive();
  ASSERT_TRUE(answer);
  wire::Decoder decoder(answer->payload);
  const Value object_offers = decoder.read("({I(Issss[(ss)]s)}{I(Iss)}{I(Iss)}s)");
  const auto& signals = object_offers.findItems()->at(1).find<Value::Map>()->entries;
  const auto signal = *signals.back().first.find<std::uint32_t>();
  const auto service = decoder.number<std::uint32_t>();
  const auto object = decoder.number<std::uint32_t>();
  const std::size_t before = residentBytes();
  for (std::uint64_t link = 1; link <= 1000; ++link) {
    const Value arguments = Value::tuple({service, signal, link});
    if (!deaf.trySendBytes(callFrame({service, object, 0}, arguments))) break;
  }
  TcpClient loud(running_.port());
  const std::string noise(1024, 'x');
  constexpr int kRaised = 100;
  for (int k = 0; k < kRaised; ++k) {
    const auto id = loud.call({memory, 1, raise}, Value::tuple("(sm)", {"Noise", noise}));
    loud.answer(id, "v");
  }
  expectWell();
  EXPECT_LT(residentBytes(), before + (64U << 20U));
  std::size_t got = 0;  // of its events, before it was closed
  while (const auto message = deaf.receive()) {
    got += message->type == wire::MessageType::Event ? 1 : 0;
  }
  EXPECT_GT(got, 1000U);
  EXPECT_LT(got, kRaised * 1000U);
}

TEST_F(HostileClient, ASignatureNestedAHundredThousandDeepIsAnError) {
  TcpClient client(running_.port());
  const std::uint32_t memory = client.service("ALMemory");
  wire::Message message;
  message.id = 77;
  message.address = {memory, 1, client.method(memory, "ping")};
  message.flags = wire::kFlagDynamic;
  wire::appendText(message.payload, std::string(100000, '[') + "i" + std::string(100000, ']'));
  client.sendBytes(encodeFrame(message));
  EXPECT_NE(client.answer(77, "b").findText(), nullptr);
  expectWell();
}

TEST_F(HostileClient, OneThatAnnouncesFourGigabytesIsClosed) {
  const std::size_t before = residentBytes();
  for (const bool is_open : {false, true}) {
    const BareSocket announcer(running_.port());
    if (is_open) announcer.send(callFrame({1, 1, 108}, Value::tuple({})));
    wire::Bytes header = callFrame({1, 1, 108}, Value::tuple({}));
    std::fill(header.begin() + 8, header.begin() + 12, std::uint8_t{0xFF});  // the payload's size
    announcer.send(header);
    EXPECT_TRUE(announcer.isClosed(0));
  }
  EXPECT_LT(residentBytes(), before + (16U << 20U));
  expectWell();
}

TEST_F(HostileClient, ManyThatSendLargeHalvesAndSleepTakeNoMoreThanTheBudget) {
  const std::size_t before = residentBytes();
  wire::Bytes half = callFrame({1, 1, 108}, Value::tuple({}));
  half.resize(12U << 20U, 'x');  // of 16 MiB announced
  const std::uint32_t size = wire::kMaxPayload;
  std::copy_n(reinterpret_cast<const std::uint8_t*>(&size), sizeof size, half.begin() + 8);
  std::vector<std::unique_ptr<BareSocket>> sleepers;
  for (int k = 0; k < 60; ++k) {  // 720 MiB
    sleepers.push_back(std::make_unique<BareSocket>(running_.port()));
    sleepers.back()->send(callFrame({1, 1, 108}, Value::tuple({})));
    sleepers.back()->send(half);
  }
  expectWell();
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the thread sanitizer's own memory is several times what the daemon holds";
#endif
  EXPECT_LT(residentBytes(), before + 2 * ByteBudget::kMost);  // a vector may have grown twofold
}

TEST_F(HostileClient, ItCanNotUnregisterOrMoveTheServiceOfAnotherClient) {
  TcpClient host(running_.port());
  services::ServiceInfo info;
  info.name = "Mine";
  const auto as_value = [&info] { return toValue(info, services::ServiceInfoFields::Six); };
  const Value entered = host.answer(host.call({1, 1, 102}, Value::tuple({as_value()})), "I");
  info.service_id = *entered.find<std::uint32_t>();
  host.answer(host.call({1, 1, 104}, Value::tuple({entered})), "v");
  TcpClient other(running_.port());
  for (const auto& [action, argument] : {std::pair(103U, entered), std::pair(105U, as_value())}) {
    const auto id = other.call({1, 1, action}, Value::tuple({argument}));
    EXPECT_NE(other.answer(id, "v").findText(), nullptr) << action;
  }
  EXPECT_EQ(witness_.service("Mine"), info.service_id);
}

TEST_F(HostileClient, ItCanNotUnregisterOrMoveWhatIsNotItsOwn) {
  TcpClient client(running_.port());
  for (const std::string name : {"ALMotion", "ServiceDirectory"}) {
    const std::uint32_t id = client.service(name);
    EXPECT_NE(client.answer(client.call({1, 1, 103}, Value::tuple({id})), "v").findText(), nullptr);
  }
  expectWell();
  EXPECT_GT(witness_.service("ALMotion"), 1U);
}

TEST_F(HostileClient, WaitsForWhatNeverEndsLeaveNothingBehind) {
  TcpClient paused(running_.port());
  const std::uint32_t usar_sim = paused.service("UsarSim");
  paused.answer(paused.call({usar_sim, 1, paused.method(usar_sim, "pause")}, Value::tuple({})),
                "v");
  const std::uint32_t motion = paused.service("ALMotion");
  const std::uint32_t move = paused.method(motion, "moveToward");
  const std::uint32_t wait = paused.method(motion, "waitUntilMoveIsFinished");
  paused.answer(paused.call({motion, 1, move}, Value::tuple({1.0F, 0.0F, 0.0F})), "v");
  const wire::Bytes call = callFrame({motion, 1, wait}, Value::tuple({}));
  wire::Bytes many;
  for (int k = 0; k < 1000; ++k) many.insert(many.end(), call.begin(), call.end());
  std::size_t after_the_first = 0;
  for (int k = 0; k < 100; ++k) {
    {
      TcpClient waiting(running_.port());
      waiting.sendBytes(many);
      waiting.service("ALMotion");  // all have been taken
    }
    if (k == 10) after_the_first = residentBytes();
  }
  EXPECT_LT(residentBytes(), after_the_first + (16U << 20U));
}

TEST_F(HostileClient, HalfAFrameHarmsNobody) {
  std::vector<std::unique_ptr<TcpClient>> half;
  for (int k = 0; k < 50; ++k) {
    half.push_back(std::make_unique<TcpClient>(running_.port()));
    wire::Bytes frame = callFrame({1, 1, 108}, Value::tuple({}));
    frame.resize(static_cast<std::size_t>(k % 28));
    half.back()->trySendBytes(frame);
  }
  expectWell();
}

}  // namespace
}  // namespace nao::daemon
