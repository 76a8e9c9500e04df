#pragma once

#include <cstdint>
#include <optional>
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
  /// Libraries of local modules, of the first robot.
  std::vector<std::string> modules;
  std::string
      scripts;  // folder of the Python client, to run the code in boxes; empty: it is not run
  std::vector<std::string> listen = {"127.0.0.1"};  // IP addresses
  std::string auth;           // file of users and tokens; empty: every client is let in
  bool insecure = false;      // every client is let in, on whatever address
  std::uint16_t port = 9559;  // robot i listens on port + i; 0: any free one for each
  /// The same for the other wires, each only if given.
  std::optional<std::uint16_t> tls_port;      // qi over TLS
  std::optional<std::uint16_t> msgpack_port;  // MessagePack-RPC
  std::optional<std::uint16_t> http_port;     // qi.js and its page
  std::string tls_dir;               // folder of the certificate; empty: the user's default
  std::string pages;                 // folder of what is served by HTTP
  std::vector<std::string> origins;  // of web pages from elsewhere that may use the robots
  double speed = 1;                  // simulated seconds per second; infinite: as fast as it goes
  double step = 0.002;               // [s] of the physics
  sim::Mode mode = sim::Mode::Implicit;
  std::uint64_t seed = 0;  // 0: no variation, every run is the same
  std::string data_dir;    // clients' files are below it; empty: they have none
  std::string naoqi;       // whose version services and wire are like; empty: the robot's own
  bool strict = false;     // open connections as libqi 4 does, not as older NAOqi
};

/// Reads "name=model" or "model". @throws InputError if empty.
RobotOption parseRobot(const std::string& text);

/// Beyond this machine only those who may are let in. @throws InputError unless `auth` is given,
/// or `insecure`, or nobody else can come.
void checkSecurity(const Options& options);

/// Where the robot of this number listens, if the first one listens on port `first`, which
/// `option` named. @throws InputError if there is no such port.
std::uint16_t portOf(std::uint16_t first, std::size_t robot, const std::string& option);

/// Reads "max" or a number above 0. @throws InputError otherwise.
double parseSpeed(const std::string& text);

}  // namespace nao::daemon
