#include "ci/executor.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include "ci/director.h"
#include "clock/clock_page.h"
#include "core/check.h"
#include "daemon/child_process.h"

namespace nao::ci {
namespace {

std::string absolute(const std::string& folder) { return std::filesystem::absolute(folder); }

std::string inFront(const char* name, const std::string& folder) {
  const char* before = std::getenv(name);
  return folder + (before && *before ? ":" + std::string(before) : "");
}

daemon::ChildProcess::Program startOf(const ClientSetup& client, const Scenario& scenario,
                                      const ExecutorSettings& settings, std::uint16_t port) {
  const auto folder = std::filesystem::path(scenario.file).parent_path();
  daemon::ChildProcess::Program start{client.command, folder.empty() ? "." : folder.string(),
                                      settings.clock_environment};
  start.environment["NAOQI_ADDRESS"] = "127.0.0.1:" + std::to_string(port);
  start.environment["PYTHONPATH"] = inFront("PYTHONPATH", absolute(settings.python_path));
  return start;
}

sigset_t noSignals() {
  sigset_t none;
  ::sigemptyset(&none);
  return none;
}

bool hasSlot(const clock::ClockPage& page, pid_t process) {
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    if (page.slots[i].process.load() == process) return true;
  }
  return false;
}

bool takesTurns(const clock::ClockPage& page, pid_t process) {
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    const clock::SlotState state = page.slots[i].state.load();
    const bool lives = state != clock::SlotState::Free && state != clock::SlotState::Ended;
    if (lives && page.slots[i].process.load() == process) return true;
  }
  return false;
}

/// The clients of a run. I/O thread, while time stands.
class Clients {
 public:
  Clients(const Scenario& scenario, const ExecutorSettings& settings)
      : scenario_(scenario), settings_(settings) {}

  /// One after the other: in lockstep the order in which they come decides the turns.
  void start(daemon::Daemon& daemon) {
    if (settings_.clock) openPage(*settings_.clock, daemon);
    for (const ClientSetup& client : scenario_.clients) {
      processes_.push_back(std::make_unique<daemon::ChildProcess>(
          startOf(client, scenario_, settings_, daemon.port(client.robot)), noSignals()));
      if (inLockstep()) await(*processes_.back());
    }
    told_.resize(processes_.size());
    stays_.resize(processes_.size());
  }

  /// Those that have ended since the last time.
  std::vector<EndedClient> takeEnded() {
    std::vector<EndedClient> ended;
    for (std::size_t i = 0; i < told_.size(); ++i) {
      if (told_[i]) continue;
      const auto code = findEnd(i);
      if (!code) continue;
      told_[i] = true;
      ended.push_back({i, *code});
    }
    return ended;
  }

 private:
  // Who has left the turns ends at this simulated time, however long the system takes to say so: a
  // process of several threads is its parent's to wait for only once all of them are gone.
  std::optional<int> findEnd(std::size_t i) {
    constexpr auto kLongest = std::chrono::seconds(2);  // of the wall
    const daemon::ChildProcess& process = *processes_[i];
    auto code = process.findEnd();
    if (code || !inLockstep() || stays_[i] || takesTurns(*settings_.clock, process.id())) {
      return code;
    }
    const auto until = std::chrono::steady_clock::now() + kLongest;
    while (!(code = process.findEnd()) && std::chrono::steady_clock::now() < until) {
      std::this_thread::sleep_for(std::chrono::microseconds(50));
    }
    stays_[i] = !code;  // it runs on beside the turns
    return code;
  }

  static void openPage(clock::ClockPage& page, daemon::Daemon& daemon) {
    std::size_t i = 0;
    for (std::size_t robot = 0; robot < daemon.robotCount(); ++robot) {
      for (const std::uint16_t port : daemon.endpoints(robot).gatedPorts()) {
        if (i + 1 < clock::kPorts) page.ports[i++] = port;
      }
    }
    live(page);
    page.ready = 1;
  }

  // The scenario itself lives in the world's time, without ever having a turn: before clients have
  // come and after they have gone, time goes on.
  static void live(clock::ClockPage& page) {
    clock::Slot& slot = page.slots[0];
    slot.process = ::getpid();
    slot.thread = ::getpid();
    slot.order = ++page.last_order;
    slot.deadline = slot.alarm = clock::kNever;
    slot.state = clock::SlotState::Queued;
    page.slots_used = 1;
  }

  bool inLockstep() const {
    return settings_.clock && settings_.clock->mode == clock::Mode::Lockstep;
  }

  // Until it takes part in the turns, or has ended without that.
  void await(const daemon::ChildProcess& process) const {
    constexpr auto kLongest = std::chrono::seconds(10);  // of the wall; a program starts in 0.1 s
    const auto until = std::chrono::steady_clock::now() + kLongest;
    while (!hasSlot(*settings_.clock, process.id()) && !process.findEnd()) {
      if (std::chrono::steady_clock::now() > until) {
        throw InputError("a client has not begun after 10 s");
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  const Scenario& scenario_;
  const ExecutorSettings& settings_;
  std::vector<std::unique_ptr<daemon::ChildProcess>> processes_;
  std::vector<bool> told_;   // that it ended
  std::vector<bool> stays_;  // it did not end when it left the turns
};

}  // namespace

daemon::Options optionsFor(const Scenario& scenario, const ExecutorSettings& settings) {
  daemon::Options options;
  options.robots = scenario.robots;
  options.world = scenario.world_file;
  options.made_world = scenario.world;
  options.robots_dir = settings.robots_dir;
  options.behaviors = settings.behaviors;
  options.port = 0;
  options.speed = settings.speed;
  options.seed = scenario.seed;
  options.record = settings.record;
  options.wire_faults = std::any_of(
      scenario.events.begin(), scenario.events.end(),
      [](const Event& event) { return std::holds_alternative<DisturbWire>(event.deed); });
  if (!scenario.clients.empty()) options.clock = settings.clock;
  return options;
}

Result execute(const Scenario& scenario, const ExecutorSettings& settings) {
  daemon::Daemon daemon(optionsFor(scenario, settings));
  Clients clients(scenario, settings);
  Director director(scenario, daemon,
                    {[&daemon] { daemon.stop(); }, [&clients] { return clients.takeEnded(); }});
  daemon.run([&] { clients.start(daemon); });
  Result result = director.result();
  result.hash = daemon.runHash();
  return result;
}

}  // namespace nao::ci
