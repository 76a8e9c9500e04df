#include "bench/wire_server.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "daemon/daemon.h"
#include "daemon/descriptor_limit.h"
#include "daemon/large_blocks.h"
#include "daemon/tcp_stream.h"
#include "naoqi_api/wire/connection.h"

namespace nao::bench {
namespace {

/// Counts bytes in, sends bytes out.
class Echo : public wire::Connection {
 public:
  explicit Echo(Send send) : send_(std::move(send)) {}

  void receive(const std::uint8_t* bytes, std::size_t count) override {
    head_.insert(head_.end(), bytes, bytes + count);
    if (asked_ == 0) {
      if (head_.size() < 8) return;
      std::memcpy(&asked_, head_.data(), 4);
      std::memcpy(&answered_, head_.data() + 4, 4);
      head_.erase(head_.begin(), head_.begin() + 8);
    }
    while (head_.size() >= asked_) {
      head_.erase(head_.begin(), head_.begin() + asked_);
      send_(rpc::Bytes(answered_, 'x'));
    }
  }
  void hold() override {}
  void resume() override {}
  bool isHeld() const override { return false; }
  bool wantsClose() const override { return false; }
  void onBroken(std::function<void()> /*broken*/) override {}
  std::size_t bytesHeld() const override { return 0; }
  std::uint64_t messagesTaken() const override { return 0; }
  bool isOpen() const override { return true; }

 private:
  Send send_;
  std::vector<std::uint8_t> head_;
  std::uint32_t asked_ = 0;
  std::uint32_t answered_ = 0;
};

daemon::Options options() {
  daemon::Options options;
  options.robots = {{"nao", "nao_h25_v50", {}}};
  options.world = NAO_SOURCE_DIR "/worlds/empty.yaml";
  options.robots_dir = NAO_SOURCE_DIR "/robots";
  options.port = 0;
  return options;
}

[[noreturn]] void serve(int ready, Lateness& lateness) {
  daemon::raiseDescriptorLimit();
  daemon::keepLargeBlocks();
  daemon::Daemon daemon(options());
  daemon::Server echo(
      daemon.io(), {{"127.0.0.1"}, 0, "echo"},
      [](boost::asio::ip::tcp::socket socket, daemon::Stream::ReadBuffer& buffer) {
        return std::make_unique<daemon::TcpStream>(std::move(socket), buffer);
      },
      [](const std::string& /*endpoint*/, wire::Connection::Send send) {
        return std::make_unique<Echo>(std::move(send));
      });
  const std::array<std::uint16_t, 2> ports{daemon.port(0), echo.port()};
  daemon.onCycle([&lateness](std::chrono::nanoseconds late) {
    const std::size_t number = lateness.count.load(std::memory_order_relaxed);
    lateness.late_ms[number % Lateness::kMost] = 1e-6F * static_cast<float>(late.count());
    lateness.count.store(number + 1, std::memory_order_release);
  });
  daemon.stopOnSignals();
  daemon.run([&] { (void)!::write(ready, ports.data(), sizeof ports); });
  echo.close();
  std::_Exit(0);
}

}  // namespace

WireServer startWireServer() {
  int ready[2];
  if (::pipe(ready) != 0) std::abort();
  void* const shared =
      ::mmap(nullptr, sizeof(Lateness), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) std::abort();
  auto* const lateness = new (shared) Lateness;
  WireServer server;
  server.lateness = lateness;
  server.process = ::fork();
  if (server.process == 0) serve(ready[1], *lateness);
  std::array<std::uint16_t, 2> ports{};
  if (::read(ready[0], ports.data(), sizeof ports) != sizeof ports) std::abort();
  server.port = ports[0];
  server.echo_port = ports[1];
  return server;
}

void stopWireServer(const WireServer& server) {
  ::kill(server.process, SIGTERM);
  ::waitpid(server.process, nullptr, 0);
}

}  // namespace nao::bench
