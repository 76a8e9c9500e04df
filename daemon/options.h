#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/frames.h"
#include "runtime/simulation.h"

namespace nao::daemon {

/// One robot to host: `name=model`, or the model's name for both.
struct RobotOption {
  std::string name;
  std::string model;
  Pose2 start;
};

/// What `usarnaoqi serve` is told.
struct Options {
  std::vector<RobotOption> robots;  // empty: those of the world file, else one nao_h21_v33
  std::string world = "worlds/empty.yaml";
  std::string robots_dir = "robots";
  /// Folders of motions and behaviors that every robot has installed, beside those in its own
  /// robots_dir/<model>/motions; later ones win.
  std::vector<std::string> behaviors;
  std::string
      scripts;  // folder of the Python client, to run the code in boxes; empty: it is not run
  std::string listen = "127.0.0.1";
  std::uint16_t port = 9559;  // robot i listens on port + i; 0: any free one for each
  double speed = 1;           // simulated seconds per second; infinite: as fast as it goes
  double step = 0.002;        // [s] of the physics
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 0;  // 0: no variation, every run is the same
  bool strict = false;     // open connections as libqi 4 does, not as older NAOqi
};

/// Reads "name=model" or "model". @throws InputError if empty.
RobotOption parseRobot(const std::string& text);

/// Where the robot of this number listens. @throws InputError if there is no such port.
std::uint16_t portOf(const Options& options, std::size_t robot);

/// Reads "max" or a number above 0. @throws InputError otherwise.
double parseSpeed(const std::string& text);

}  // namespace nao::daemon
