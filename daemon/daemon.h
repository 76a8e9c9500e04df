#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "daemon/camera_loop.h"
#include "daemon/director.h"
#include "daemon/local_modules.h"
#include "daemon/lola_sender.h"
#include "daemon/options.h"
#include "daemon/robot_host.h"
#include "daemon/robot_loop.h"
#include "daemon/world_turns.h"
#include "runtime/recorder.h"
#include "runtime/run_hash.h"
#include "runtime/simulation.h"

namespace nao::daemon {

class LocalPictures;

/// The whole program behind `usarnaoqi serve`: one simulation thread, one camera thread, and the
/// caller's thread for all clients.
class Daemon {
 public:
  /// Loads the files and opens the ports. @throws InputError with one sentence for the user.
  explicit Daemon(const Options& options);
  ~Daemon();

  /// Serves until stop(). Calls `ready` once clients may connect.
  void run(const std::function<void()>& ready = {});

  /// Ends run(), once local modules have ended, or the world has come to the end of what LoLA
  /// clients have ordered (Options::lola_to_the_end). From any thread.
  void stop();

  /// From now on Ctrl-C and SIGTERM end run().
  void stopOnSignals();

  std::size_t robotCount() const { return hosts_.size(); }
  std::string robotName(std::size_t i) const { return simulation_.robotName(i); }
  const RobotModel& robotModel(std::size_t i) { return simulation_.robot(i).model(); }
  const RobotEndpoints& endpoints(std::size_t i) const { return hosts_[i]->endpoints(); }
  const LolaServer* lola(std::size_t i) const { return hosts_[i]->lola(); }
  std::vector<std::uint16_t> lolaCameraPorts(std::size_t i) const {
    return hosts_[i]->lolaCameraPorts();
  }
  std::uint16_t port(std::size_t i) const { return endpoints(i).qiPort(); }

  /// The caller's thread of run(), for what else is to run on it.
  boost::asio::io_context& io() { return io_; }

  /// Before run(): see RobotLoop::onCycle().
  void onCycle(std::function<void(std::chrono::nanoseconds late)> told) {
    loop_.onCycle(std::move(told));
  }

  /// Before run(): `director`, which outlives run(), follows the world.
  void follow(Director& director);

  /// Of a robot, for who follows the world; I/O thread.
  memory::RobotMemory& memory(std::size_t robot) { return hosts_[robot]->memory(); }

  /// From now on; with Options::wire_faults alone. I/O thread.
  void disturbWire(std::size_t robot, const WireFault& fault) { hosts_[robot]->wire()->set(fault); }

  /// Before run(): what the seed has drawn for this run, by name; empty without one.
  std::map<std::string, double> draw() { return simulation_.world().draw(); }

  /// Pictures that came too late to be drawn, of all robots; only at a fixed speed.
  std::int64_t droppedPictures() const;

  /// After run(): how far the simulation came.
  LoopState state() const { return *loop_.state().get(); }

  /// After run(): what two runs share only if they went alike.
  std::uint64_t runHash() const { return run_hash_.value(); }

  /// After run(): why the recording ended before the run, one sentence; empty: it did not.
  std::string recordingFailure() const { return recorder_ ? recorder_->failure() : ""; }

 private:
  Daemon(const Options& options, const runtime::RunStart& start);
  void scheduleDelivery();
  void deliver();
  void makeHosts();
  void startLola();
  bool lolaHolds(SimTime now);
  void finishLola();
  void startClock();
  void inviteModules();
  void startModules();

  Options options_;
  boost::asio::io_context io_{1};
  boost::asio::signal_set signals_{io_};
  boost::asio::steady_timer patience_{io_};  // with modules that are to end
  runtime::Simulation simulation_;
  std::unique_ptr<WorldTurns> turns_;  // none outside of lockstep
  runtime::RunHash run_hash_;
  std::optional<runtime::Recorder> recorder_;  // none without --record
  RobotLoop loop_;
  CameraLoop cameras_;
  std::unique_ptr<LocalPictures> lent_pictures_;  // none without --module
  std::unique_ptr<LocalModules> modules_;
  std::size_t modules_robot_ = 0;
  std::string module_token_;
  std::vector<std::unique_ptr<RobotHost>> hosts_;
  std::vector<std::unique_ptr<LolaSender>> lola_;  // of the robots that have a socket
  Director* director_ = nullptr;
  std::atomic<bool> delivery_due_{false};
};

}  // namespace nao::daemon
