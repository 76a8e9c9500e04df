#pragma once

#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "daemon/daemon.h"

namespace nao::daemon {

/// These robots in an empty world, as fast as it goes, on any free ports.
inline Options optionsFor(std::vector<RobotOption> robots) {
  Options options;
  options.robots = std::move(robots);
  options.world = NAO_SOURCE_DIR "/worlds/empty.yaml";
  options.robots_dir = NAO_SOURCE_DIR "/robots";
  options.port = 0;
  options.speed = std::numeric_limits<double>::infinity();
  return options;
}

/// One Nao and a red ball before it.
inline Options withRedBall() {
  Options options = optionsFor({{"nao", "nao_h25_v50", {}}});
  options.world = NAO_SOURCE_DIR "/worlds/red_ball.yaml";
  return options;
}

inline Options optionsForOne() { return optionsFor({{"nao", "nao_h21_v33", {}}}); }

/// A daemon that runs until the end of the test.
class Running {
 public:
  explicit Running(const Options& options) : daemon_(options), thread_([this] { daemon_.run(); }) {}
  ~Running() {
    daemon_.stop();
    thread_.join();
  }
  std::uint16_t port(std::size_t robot = 0) const { return daemon_.port(robot); }
  std::vector<std::string> addresses() const { return daemon_.endpoints(0).otherAddresses(); }

 private:
  Daemon daemon_;
  std::thread thread_;
};

}  // namespace nao::daemon
