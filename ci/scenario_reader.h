#pragma once

#include <string>
#include <vector>

#include "ci/scenario.h"
#include "core/config.h"

namespace nao::ci {

/// Reads what a scenario's file says happens and is expected; what it names (robots, balls,
/// clients, joints, sensors) must be there: else an InputError with file, line and reason.
class ScenarioReader {
 public:
  /// World, robots and clients of `scenario` are there already.
  explicit ScenarioReader(Scenario& scenario) : scenario_(scenario) {}

  void readEvents(Config& file);
  void readExpectations(Config& file);

 private:
  using Deed = decltype(Event::deed);

  std::size_t robot(Config& entry);  // at `robot`; without it the first
  std::size_t ball(Config& entry);   // at `ball`; without it the first
  std::size_t client(Config& entry);
  std::size_t camera(Config& entry, std::size_t robot);
  Joint joint(Config& entry, std::size_t robot);
  Duration moment(Config& entry, const std::string& key);  // within the scenario
  std::string nameOf(std::size_t robot) const { return scenario_.robots[robot].name; }

  Deed readPush(Config& push);
  Deed readPress(Config& press);
  Deed readPlaceRobot(Config& place);
  Deed readPlaceBall(Config& place);
  Deed readKill(Config& kill);
  Deed readFreeze(Config& freeze);
  Deed readNoise(Config& noise);
  Deed readHeat(Config& heat);
  Deed readBattery(Config& battery);
  Deed readLens(Config& lens);
  Deed readWet(Config& wet);
  Deed readWire(Config& wire);
  std::string sensor(Config& entry, std::size_t robot);  // that can fail

  Condition readUpright(Config& upright);
  Condition readFallen(Config& fallen);
  Condition readPlace(Config& place);
  Condition readMemory(Config& memory);
  Condition readEvent(Config& event);
  Condition readSaid(Config& said);
  Condition readExit(Config& exit);
  Condition readImage(Config& image);
  Condition readJoint(Config& joint);
  Condition readLimits(Config& limits);
  When readWhen(Config& entry, const Condition& condition);
  std::string described(const Condition& condition) const;

  Scenario& scenario_;
};

/// The one key of an entry that is not among `common` and is among `known`: what it is about.
std::string kindOf(Config& entry, const std::vector<std::string>& common,
                   const std::vector<std::string>& known);

}  // namespace nao::ci
