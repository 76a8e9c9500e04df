// How late a daemon at 1x sends LoLA's frames to a client that answers each of them, while another
// looks through the top camera; beside a bare loop of clock_nanosleep in a process that does
// nothing else, both in turn. lola_bench [SECONDS]: one JSON object of figures.
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>
#include <thread>
#include <vector>

#include "daemon/daemon.h"
#include "daemon/lola_link.h"
#include "naoqi_api/wire/msgpack_codec.h"

namespace nao::bench {
namespace {

using boost::asio::ip::tcp;

constexpr long kCycle = 12'000'000;  // [ns]
constexpr int kTurns = 10;           // of each

/// What the daemon's process tells this one.
struct Shared {
  static constexpr std::size_t kMost = 1U << 20U;
  std::atomic<std::size_t> count{0};
  std::array<float, kMost> late_ms{};
};

std::uint16_t startDaemon(const std::string& path, Shared& shared, pid_t& process) {
  int ready[2];
  if (::pipe(ready) != 0) std::abort();
  process = ::fork();
  if (process == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    daemon::Options options;
    options.world = NAO_SOURCE_DIR "/worlds/field_2020.yaml";
    options.robots = {{"nao", "nao_h25_v60", {}}};
    options.robots_dir = NAO_SOURCE_DIR "/robots";
    options.port = 0;
    options.lola = {{"", path}};
    options.lola_camera_port = 0;
    daemon::Daemon daemon(options);
    daemon.onCycle([&](std::chrono::nanoseconds late) {
      // What began at this time is what was published last: others than LoLA's are no frames.
      if (daemon.state().time.time_since_epoch().count() % kCycle != 0) return;
      const std::size_t number = shared.count.load(std::memory_order_relaxed);
      shared.late_ms[number % Shared::kMost] = 1e-6F * static_cast<float>(late.count());
      shared.count.store(number + 1, std::memory_order_release);
    });
    daemon.stopOnSignals();
    const std::uint16_t port = daemon.lolaCameraPorts(0).front();
    daemon.run([&] { (void)!::write(ready[1], &port, sizeof port); });
    std::_Exit(0);
  }
  std::uint16_t port = 0;
  if (::read(ready[0], &port, sizeof port) != sizeof port) std::abort();
  return port;
}

std::string actuators() {
  const auto list = [](float value) {
    return rpc::Value::list(std::vector<rpc::Value>(25, rpc::Value(value)));
  };
  rpc::Value::Map map{"s", "m", {{"Position", list(0)}, {"Stiffness", list(0.5F)}}};
  rpc::Bytes bytes;
  wire::packValue(bytes, rpc::Value(std::move(map)), {});
  return {bytes.begin(), bytes.end()};
}

/// For so long the client's whole life: it reads and answers. What the daemon was late by.
std::vector<float> lolaTurn(daemon::LolaLink& link, const Shared& shared, double seconds) {
  static const std::string kAnswer = actuators();
  const std::size_t from = shared.count.load(std::memory_order_acquire);
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < end) {
    link.receive();
    link.send(kAnswer);
  }
  std::vector<float> late;
  for (std::size_t k = from; k < shared.count.load(std::memory_order_acquire); ++k) {
    late.push_back(shared.late_ms[k % Shared::kMost]);
  }
  return late;
}

/// The same time asleep, but for waking every 12 ms; late by more than that, it begins anew, as the
/// daemon does.
std::vector<float> sleepTurn(double seconds) {
  const auto nanoseconds = [](const timespec& time) {
    return time.tv_sec * 1'000'000'000L + time.tv_nsec;
  };
  std::vector<float> late;
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  long due = nanoseconds(now);
  const long end = due + static_cast<long>(seconds * 1e9);
  while (due < end) {
    due += kCycle;
    const timespec until{due / 1'000'000'000L, due % 1'000'000'000L};
    ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    const long lateness = nanoseconds(now) - due;
    late.push_back(1e-6F * static_cast<float>(lateness));
    if (lateness > kCycle) due = nanoseconds(now);
  }
  return late;
}

/// Takes every picture that comes.
void look(std::uint16_t port, std::atomic<long>& pictures) {
  boost::asio::io_context io;
  tcp::socket socket(io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  std::vector<char> picture(16 + 640 * 480 * 2);
  boost::system::error_code error;
  while (!error) {
    boost::asio::read(socket, boost::asio::buffer(picture), error);
    if (!error) ++pictures;
  }
}

double quantile(std::vector<float>& values, double part) {
  std::sort(values.begin(), values.end());
  return double{values.at(static_cast<std::size_t>(part * static_cast<double>(values.size() - 1)))};
}

double load() {
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  return load;
}

void run(double seconds) {
  std::string folder = (std::filesystem::temp_directory_path() / "lola_bench_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) std::abort();
  void* const memory =
      ::mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) std::abort();
  auto& shared = *new (memory) Shared;
  pid_t process = 0;
  const std::uint16_t port = startDaemon(folder + "/robocup", shared, process);
  std::atomic<long> pictures{0};
  std::thread viewer([&] { look(port, pictures); });
  daemon::LolaLink link(folder + "/robocup");
  std::vector<float> sent;
  std::vector<float> slept;
  lolaTurn(link, shared, 1);  // warm
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto lola = lolaTurn(link, shared, seconds / kTurns / 2);
    const auto bare = sleepTurn(seconds / kTurns / 2);
    sent.insert(sent.end(), lola.begin(), lola.end());
    slept.insert(slept.end(), bare.begin(), bare.end());
  }
  ::kill(process, SIGTERM);
  ::waitpid(process, nullptr, 0);
  viewer.join();
  std::filesystem::remove_all(folder);
  std::printf(
      "{\"lola_send_p50_wall_ms\": %.4g, \"lola_send_p99_wall_ms\": %.4g, "
      "\"sleep_p50_wall_ms\": %.4g, \"sleep_p99_wall_ms\": %.4g, \"lola_frames\": %zu, "
      "\"lola_pictures\": %ld, \"lola_load\": %.3g}\n",
      quantile(sent, 0.5), quantile(sent, 0.99), quantile(slept, 0.5), quantile(slept, 0.99),
      sent.size(), pictures.load(), load());
}

}  // namespace
}  // namespace nao::bench

int main(int argc, char** argv) {
  nao::bench::run(argc > 1 ? std::atof(argv[1]) : 60);
  return 0;
}
