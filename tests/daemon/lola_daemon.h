#pragma once

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "daemon/daemon.h"
#include "tests/core/temporary_folder.h"
#include "tests/daemon/lola_client.h"
#include "tests/daemon/running_daemon.h"

namespace nao::daemon {

/// A daemon that can be ended to see how far it came.
class LolaDaemon {
 public:
  explicit LolaDaemon(const Options& options)
      : daemon_(options), thread_([this] { daemon_.run(); }) {}
  ~LolaDaemon() { stop(); }
  LoopState stop() {
    daemon_.stop();
    if (thread_.joinable()) thread_.join();
    return daemon_.state();
  }
  /// Waits until it is this late there.
  void awaitTime(SimTime time) const {
    while (daemon_.state().time < time) std::this_thread::yield();
  }
  std::uint16_t port(std::size_t robot = 0) const { return daemon_.port(robot); }
  const RobotModel& model() { return daemon_.robotModel(0); }

 private:
  Daemon daemon_;
  std::thread thread_;
};

/// With a socket in a folder of its own.
class LolaServerTest : public testing::Test {
 protected:
  static constexpr double kPatience = 60;  // [s] of the wall: no client of these tests is so slow

  Options lockstep() const {
    Options options = optionsFor({});
    options.lola = {{"", path_}};
    options.lola_lockstep = kPatience;
    return options;
  }
  Options freeRunning() const {
    Options options = lockstep();
    options.lola_lockstep.reset();
    return options;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path() + "/robocup";
};

/// A frame that turns the head and nothing else.
inline LolaClient::Map drive(float head_yaw, float stiffness = 1) {
  std::vector<rpc::Value> position(25, rpc::Value(0.0F));
  position[0] = head_yaw;
  return {{"Position", rpc::Value::list(std::move(position))},
          {"Stiffness", LolaClient::list(stiffness)}};
}

}  // namespace nao::daemon
