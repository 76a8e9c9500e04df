#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "ci/expectation.h"
#include "core/world_model.h"
#include "daemon/options.h"
#include "runtime/world_request.h"

namespace nao::ci {

/// A program that runs beside the world; its folder is the scenario's.
struct ClientSetup {
  std::string name;
  std::vector<std::string> command;
  std::size_t robot = 0;    // whose address it is given
  bool background = false;  // ends with the world; its exit code says nothing
};

/// Packets between a robot and its clients are late, or lost and sent again.
struct DisturbWire {
  std::size_t robot = 0;
  Duration delay{};  // on each way
  double loss = 0;   // part of the packets
  Duration duration{};
};

/// Something that happens at a time.
struct Event {
  Duration at{};
  std::variant<runtime::WorldRequest, DisturbWire> deed;
  std::string text;  // "push"
};

/// A world, what runs and happens in it, and what is expected of it: one file with one seed.
/// docs/scenarios.md explains the format.
struct Scenario {
  std::string name;   // of the file, without its ending
  std::string file;   // as the user named it
  std::string about;  // one sentence
  std::uint64_t seed = 0;
  std::map<std::string, double> drawn;  // the numbers of its `spread`

  std::string world_file;
  std::shared_ptr<const WorldModel> world;
  std::vector<daemon::RobotOption> robots;
  std::vector<std::shared_ptr<const RobotModel>> models;  // of the robots
  std::vector<ClientSetup> clients;
  Duration duration{};
  std::vector<Event> events;  // by time
  std::vector<Expectation> expectations;
};

/// Where things named in a scenario are found.
struct Places {
  std::string worlds_dir = "worlds";
  std::string robots_dir = "robots";
};

/// The seeds a scenario asks for.
/// @throws InputError with file, line and reason, as loadScenario().
std::vector<std::uint64_t> loadSeeds(const std::string& file);

/// @throws InputError with file, line and reason for whatever is wrong in it: unknown keys,
/// numbers out of range, robots, joints, sensors, balls and clients that there are not.
Scenario loadScenario(const std::string& file, std::uint64_t seed, const Places& places);

}  // namespace nao::ci
