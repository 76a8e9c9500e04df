#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clock/clock_page.h"
#include "core/frames.h"
#include "naoqi_api/wire/lola_sensors.h"
#include "runtime/simulation.h"

namespace nao::daemon {

/// One robot to host: `name=model`, or the model's name for both.
struct RobotOption {
  std::string name;
  std::string model;
  Pose2 start;
  std::optional<Color> team = std::nullopt;  // of its shirt
  std::vector<EffectSetting> effects = {};   // beside those of its file
};

/// A LoLA socket: `ROBOT=PATH`, or a path alone for the first robot that has none.
struct LolaOption {
  std::string robot;  // its name; empty: not said
  std::string path = "/tmp/robocup";
};

/// What `usarnaoqi serve` is told.
struct Options {
  std::vector<RobotOption> robots;  // empty: those of the world file, else one nao_h21_v33, or
                                    // with LoLA a nao_h25_v60
  bool hung_up = false;              // every robot by its torso, feet in the air
  std::string world = "worlds/empty.yaml";
  std::shared_ptr<const WorldModel> made_world;  // in place of that file; null: none
  std::string robots_dir = "robots";
  /// Folders of motions and behaviors that every robot has installed, beside those in its own
  /// robots_dir/<model>/motions; later ones win.
  std::vector<std::string> behaviors;
  /// Libraries of local modules, [ROBOT=]FILE.
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
  std::vector<LolaOption> lola;      // robots that offer LoLA, at 12 ms a cycle
  wire::LolaBattery lola_battery = wire::LolaBattery::StatusFirst;
  /// Top camera of the first robot with LoLA; the bottom one is next, then the next robot's.
  std::optional<std::uint16_t> lola_camera_port;
  std::string lola_camera_memory;       // first part of the rings' names; empty: there are none
  std::optional<double> lola_lockstep;  // [s] of the wall that the world waits for an answer
  /// With lola_lockstep: when all LoLA clients have gone, time stands, and ends there.
  bool lola_to_the_end = false;
  double speed = 1;     // simulated seconds per second; infinite: as fast as it goes
  double step = 0.002;  // [s] of the physics
  sim::Mode mode = sim::Mode::Implicit;
  bool wire_faults = false;  // the wires of qi and msgpack-RPC can be disturbed
  bool paused = false;       // time stands at first, until UsarSim.resume or step
  std::uint64_t seed = 0;    // 0: no variation, every run is the same
  std::string record;        // the run is written into this file; empty: into none
  std::string data_dir;      // clients' files are below it; empty: they have none
  std::string naoqi;         // whose version services and wire are like; empty: the robot's own
  /// Who may see the cameras of LoLA, which ask for no token: this machine, and with `insecure`
  /// everybody.
  std::vector<std::string> lolaCameraHosts() const {
    return insecure ? listen : std::vector<std::string>{"127.0.0.1"};
  }

  /// Where programs see this world's time and take turns with it; null: nowhere. Outlives it.
  clock::ClockPage* clock = nullptr;

  bool strict = false;  // open connections as libqi 4 does, not as older NAOqi
};

/// Reads "name=model" or "model". @throws InputError if empty.
RobotOption parseRobot(const std::string& text);

/// Reads "ROBOT=PATH", "PATH" or nothing. @throws InputError if the path is empty.
LolaOption parseLola(const std::string& text);

/// The socket of each of these robots; empty: it has none. @throws InputError for a robot that
/// there is not, or that has two, and for a path that two have.
std::vector<std::string> lolaPaths(const std::vector<LolaOption>& lola,
                                   const std::vector<std::string>& robots);

/// Reads "status-first" or "current-first". @throws InputError otherwise.
wire::LolaBattery parseLolaBattery(const std::string& text);

/// Beyond this machine only those who may are let in. @throws InputError unless `auth` is given,
/// or `insecure`, or nobody else can come.
void checkSecurity(const Options& options);

/// Where the robot of this number listens, if the first one listens on port `first`, which
/// `option` named. @throws InputError if there is no such port.
std::uint16_t portOf(std::uint16_t first, std::size_t robot, const std::string& option);

/// Reads "max" or a number above 0. @throws InputError otherwise.
double parseSpeed(const std::string& text);

}  // namespace nao::daemon
