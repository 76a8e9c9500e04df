#pragma once

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <alcommon/alproxy.h>
#include <alvalue/alvalue.h>

extern char** environ;

namespace usarnaoqi {

/// A simulated world of a test's own, on a free port. Time stands until it is told to pass, so that
/// nothing depends on the wall's clock; it ends with this object. The simulator is the program that
/// the environment's USARNAOQI names, else `usarnaoqi` of the PATH.
class TestWorld {
 public:
  /// `options` of `usarnaoqi serve`: {"--robot", "nao_h25_v50", "--seed", "3"}.
  /// @throws std::runtime_error if it does not start.
  explicit TestWorld(const std::vector<std::string>& options = std::vector<std::string>()) {
    start(options);
    try {
      readPort();
      simulator_.reset(new AL::ALProxy("UsarSim", "127.0.0.1", port_));
      simulator_->callVoid("pause");
      step_ = simulator_->call<double>("stepSize");
      reader_ = std::thread([this] { drain(); });
    } catch (...) {
      end();
      throw;
    }
  }
  ~TestWorld() { end(); }
  TestWorld(const TestWorld&) = delete;
  TestWorld& operator=(const TestWorld&) = delete;

  /// Of the first robot, on this machine.
  int port() const { return port_; }
  AL::ALProxy proxy(const std::string& service) const {
    return AL::ALProxy(service, "127.0.0.1", port_);
  }
  /// The truth and the hand of the simulator's user.
  const AL::ALProxy& simulator() const { return *simulator_; }

  /// Simulated [s].
  double time() const { return simulator_->call<double>("time"); }

  /// Lets so much time [s] pass, and no more.
  void step(double seconds) const {
    simulator_->callVoid("step", std::max(1, static_cast<int>(std::lround(seconds / step_))));
  }

  /// Lets time pass until the condition holds; false if it does not within so many s.
  template <class Condition>
  bool runUntil(Condition condition, double within) const {
    const int beats = static_cast<int>(std::lround(within / kBeat));
    for (int i = 0; i < beats && !condition(); ++i) step(kBeat);
    return condition();
  }

  /// Calls a method and lets time pass until it has ended; false if it does not within so many s.
  template <class... P>
  bool run(const AL::ALProxy& service, double within, const std::string& method,
           const P&... arguments) const {
    const int task = service.pCall(method, arguments...);
    return runUntil([&] { return !service.isRunning(task); }, within);
  }

  /// x, y [m], heading [rad]: where the first robot really stands.
  std::vector<float> floorPose() const { return simulator_->call<std::vector<float>>("floorPose"); }
  /// How far its torso tilts from upright [rad].
  double tilt() const {
    const auto pose = simulator_->call<std::vector<float>>("torsoPose");
    return std::acos(std::cos(pose.at(3)) * std::cos(pose.at(4)));
  }

 private:
  static constexpr double kBeat = 0.01;  // [s] between two looks

  void start(const std::vector<std::string>& options) {
    const char* named = std::getenv("USARNAOQI");
    std::vector<std::string> words = {named && *named ? named : "usarnaoqi",
                                      "serve",
                                      "--port",
                                      "0",
                                      "--paused",
                                      "--speed",
                                      "max"};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(&word[0]);
    pointers.push_back(nullptr);
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    const int error =
        ::posix_spawnp(&process_, pointers[0], &actions, nullptr, pointers.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    output_ = ends[0];
    if (error == 0) return;
    process_ = 0;
    end();
    throw std::runtime_error("can not start " + words.front());
  }

  // Of the line "ready: NAME (MODEL) at tcp://HOST:PORT".
  void readPort() {
    std::string line;
    for (char letter = 0; ::read(output_, &letter, 1) == 1 && letter != '\n';) line += letter;
    const std::size_t colon = line.rfind(':');
    if (line.compare(0, 7, "ready: ") != 0 || colon == std::string::npos) {
      throw std::runtime_error("the world did not start");
    }
    port_ = std::atoi(line.c_str() + colon + 1);
  }

  // What the daemon logs afterwards; unread, it would hold the daemon up one day.
  void drain() const {
    char said[4096];
    while (::read(output_, said, sizeof said) > 0) {
    }
  }

  void end() {
    simulator_.reset();
    if (process_ > 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
    if (reader_.joinable()) reader_.join();
    if (output_ >= 0) ::close(output_);
    process_ = 0;
    output_ = -1;
  }

  pid_t process_ = 0;
  int output_ = -1;
  int port_ = 0;
  double step_ = 0;  // [s] of the physics
  std::thread reader_;
  boost::shared_ptr<AL::ALProxy> simulator_;
};

}  // namespace usarnaoqi
