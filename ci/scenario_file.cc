#include <algorithm>
#include <filesystem>
#include <sstream>

#include "ci/scenario.h"
#include "ci/scenario_reader.h"
#include "ci/spread.h"
#include "core/check.h"
#include "core/config_node.h"
#include "core/robot_model_parts.h"

namespace nao::ci {
namespace {

namespace fs = std::filesystem;
using Presence = Config::Presence;

constexpr Interval kSeed{0, 1e9};
constexpr Interval kLength{0.01, 3600};  // [s] of a scenario
constexpr const char* kUsualModel = "nao_h21_v33";

std::vector<std::uint64_t> readSeeds(Config& file) {
  std::vector<std::uint64_t> seeds{1};
  if (!file.has("seeds")) return seeds;
  seeds.clear();
  for (const double seed : file.numbers("seeds", 0, kSeed)) {
    seeds.push_back(static_cast<std::uint64_t>(seed));
  }
  if (seeds.empty()) file.fail("`seeds`: expected at least one");
  return seeds;
}

std::string folderOf(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder.string();
}

// A shipped world by its name, or a file beside the scenario.
std::string worldFile(Config& file, const Places& places) {
  const std::string name = file.text("world", "empty");
  if (fs::path(name).extension() == ".yaml") return (fs::path(folderOf(file.file())) / name);
  const fs::path shipped = fs::path(places.worlds_dir) / (name + ".yaml");
  if (!fs::exists(shipped)) file.reject("world", "the name of a world in " + places.worlds_dir);
  return shipped;
}

void readWorld(Config& file, const Places& places, Scenario& scenario) {
  scenario.world_file = worldFile(file, places);
  const auto world = std::make_shared<WorldModel>(*loadWorldModel(scenario.world_file));
  file.map("ground", Presence::Optional, [&](Config& ground) {
    world->ground.friction = ground.number("friction", kNotNegative, world->ground.friction);
  });
  scenario.world = world;
}

// A mistake in the robot's name is one of this file.
void addRobot(Scenario& scenario, const daemon::RobotOption& robot, const Places& places) {
  scenario.robots.push_back(robot);
  scenario.models.push_back(loadRobotModel(places.robots_dir, robot.model));
}

void readRobot(Config& entry, const Places& places, Scenario& scenario) {
  daemon::RobotOption robot;
  robot.model = entry.text("model", kUsualModel);
  robot.name = entry.text("name", "nao");
  for (const auto& other : scenario.robots) {
    if (other.name == robot.name) entry.fail("`name`: '" + robot.name + "' is given twice");
  }
  if (!fs::is_directory(fs::path(places.robots_dir) / robot.model)) {
    entry.reject("model", "a robot in " + places.robots_dir);
  }
  if (entry.has("start")) {
    const auto start = entry.numbers("start", 3);
    robot.start = {start[0], start[1], start[2]};
  }
  robot.effects = readEffects(entry, "effects", *loadRobotModel(places.robots_dir, robot.model));
  addRobot(scenario, robot, places);
}

void readRobots(Config& file, const Places& places, Scenario& scenario) {
  file.list("robots", Presence::Optional,
            [&](Config& entry) { readRobot(entry, places, scenario); });
  if (!scenario.robots.empty()) return;
  for (const RobotPlace& place : scenario.world->robots) {
    addRobot(scenario, {place.name, place.model, place.start, place.team}, places);
  }
  if (scenario.robots.empty()) addRobot(scenario, {"nao", kUsualModel, {}}, places);
}

std::vector<std::string> readCommand(Config& entry) {
  if (entry.isList("run")) return entry.texts("run");
  std::istringstream words(entry.text("run"));
  std::vector<std::string> command;
  for (std::string word; words >> word;) command.push_back(word);
  return command;
}

void readClient(Config& entry, Scenario& scenario) {
  ClientSetup client;
  client.command = readCommand(entry);
  if (client.command.empty()) entry.reject("run", "a program and its arguments");
  client.name = entry.text("name", "client");
  for (const ClientSetup& other : scenario.clients) {
    if (other.name == client.name) entry.fail("`name`: '" + client.name + "' is given twice");
  }
  const std::string robot = entry.text("robot", scenario.robots.front().name);
  const auto found = std::find_if(scenario.robots.begin(), scenario.robots.end(),
                                  [&](const auto& other) { return other.name == robot; });
  if (found == scenario.robots.end()) entry.reject("robot", "the name of one of `robots`");
  client.robot = static_cast<std::size_t>(found - scenario.robots.begin());
  client.background = entry.flag("background", false);
  scenario.clients.push_back(client);
}

// Who does not say otherwise wants every program to end well.
void expectGoodEnds(Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.clients.size(); ++i) {
    const auto judged = [i](const Expectation& expectation) {
      const auto* end = std::get_if<ClientEnded>(&expectation.condition);
      return end && end->client == i;
    };
    const auto& all = scenario.expectations;
    if (scenario.clients[i].background || std::any_of(all.begin(), all.end(), judged)) continue;
    const When when{When::Kind::By, Duration::zero(), scenario.duration};
    scenario.expectations.push_back(
        {ClientEnded{i, 0}, when,
         scenario.clients[i].name + " ends with exit code 0 " + when.described(), 0});
  }
}

}  // namespace

std::vector<std::uint64_t> loadSeeds(const std::string& file) {
  ConfigNode root = parseConfigFile(file);
  drawSpread(root, 1);
  std::vector<std::uint64_t> seeds;
  Config::read(root, [&](Config& config) {
    seeds = readSeeds(config);
    for (const std::string& key : config.keys()) config.has(key);  // the rest is for others
  });
  return seeds;
}

Scenario loadScenario(const std::string& file, std::uint64_t seed, const Places& places) {
  Scenario scenario;
  scenario.name = fs::path(file).stem();
  scenario.file = file;
  scenario.seed = seed;
  ConfigNode root = parseConfigFile(file);
  scenario.drawn = drawSpread(root, seed);
  Config::read(root, [&](Config& config) {
    scenario.about = config.text("about");
    readSeeds(config);
    scenario.duration = fromSeconds(config.number("duration", kLength));
    readWorld(config, places, scenario);
    readRobots(config, places, scenario);
    config.list("clients", Presence::Optional, [&](Config& entry) { readClient(entry, scenario); });
    ScenarioReader reader(scenario);
    reader.readEvents(config);
    reader.readExpectations(config);
    expectGoodEnds(scenario);
    if (scenario.expectations.empty()) config.fail("`expect`: nothing is expected");
  });
  return scenario;
}

}  // namespace nao::ci
