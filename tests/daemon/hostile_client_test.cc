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

TEST_F(HostileClient, ItCanNotUnregisterOrMoveWhatIsNotItsOwn) {
  TcpClient client(running_.port());
  for (const std::string name : {"ALMotion", "ServiceDirectory"}) {
    const std::uint32_t id = client.service(name);
    EXPECT_NE(client.answer(client.call({1, 1, 103}, Value::tuple({id})), "v").findText(), nullptr);
  }
  expectWell();
  EXPECT_GT(witness_.service("ALMotion"), 1U);
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
