#include <algorithm>

#include "ci/scenario_reader.h"
#include "sim/faults.h"

namespace nao::ci {
namespace {

using Presence = Config::Presence;

constexpr double kFar = 1000;               // [m] the world has no edge, but numbers have
constexpr double kStrong = 10000;           // [N]
constexpr Interval kLong{0.001, 3600};      // [s]
constexpr Interval kTemperature{-20, 200};  // [deg C] of a motor

Duration lengthOf(Config& entry) { return fromSeconds(entry.number("for", kLong)); }

Vec3 vectorWithin(Config& entry, const std::string& key, double most) {
  const auto v = entry.numbers(key, 3, {-most, most});
  return {v[0], v[1], v[2]};
}

bool canBeTouched(const std::string& sensor) {
  return sensor == "ChestBoard/Button" || sensor.find("/Touch/") != std::string::npos ||
         sensor.find("/Bumper/") != std::string::npos;
}

}  // namespace

std::string kindOf(Config& entry, const std::vector<std::string>& common,
                   const std::vector<std::string>& known) {
  std::string list;
  for (const std::string& kind : known) list += (list.empty() ? "" : ", ") + kind;
  std::string found;
  for (const std::string& key : entry.keys()) {
    if (std::count(common.begin(), common.end(), key)) continue;
    if (!std::count(known.begin(), known.end(), key)) {
      entry.fail("`" + key + "`: unknown, expected one of " + list);
    }
    if (!found.empty())
      entry.fail("`" + key + "`: one entry is about one thing, see `" + found + "` there");
    found = key;
  }
  if (found.empty()) entry.fail("expected one of " + list);
  return found;
}

std::size_t ScenarioReader::robot(Config& entry) {
  if (!entry.has("robot")) return 0;
  const std::string name = entry.text("robot");
  for (std::size_t i = 0; i < scenario_.robots.size(); ++i) {
    if (scenario_.robots[i].name == name) return i;
  }
  entry.reject("robot", "the name of one of `robots`");
}

std::size_t ScenarioReader::ball(Config& entry) {
  const auto& balls = scenario_.world->balls;
  if (balls.empty()) entry.fail("this world has no ball");
  const std::string name = entry.text("ball", balls.front().name);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls[i].name == name) return i;
  }
  entry.reject("ball", "the name of a ball of the world");
}

Joint ScenarioReader::joint(Config& entry, std::size_t robot) {
  const auto joint = scenario_.models[robot]->findJoint(entry.text("joint"));
  if (!joint) entry.reject("joint", "a joint of " + scenario_.robots[robot].model);
  return *joint;
}

Duration ScenarioReader::moment(Config& entry, const std::string& key) {
  return fromSeconds(entry.number(key, {0, toSeconds(scenario_.duration)}));
}

ScenarioReader::Deed ScenarioReader::readPush(Config& push) {
  return runtime::WorldRequest(
      runtime::PushRobot{robot(push), vectorWithin(push, "force", kStrong), lengthOf(push)});
}

ScenarioReader::Deed ScenarioReader::readPress(Config& press) {
  const std::size_t who = robot(press);
  const std::string sensor = press.text("sensor");
  const auto& frames = scenario_.models[who]->frames;
  const bool known = std::any_of(frames.begin(), frames.end(),
                                 [&](const Frame& frame) { return frame.name == sensor; });
  if (!known || !canBeTouched(sensor)) {
    press.reject("sensor", "a button, bumper or tactile sensor of " + nameOf(who));
  }
  return runtime::WorldRequest(runtime::PressSensor{who, sensor, lengthOf(press)});
}

ScenarioReader::Deed ScenarioReader::readPlaceRobot(Config& place) {
  const auto pose = place.numbers("pose", 3, {-kFar, kFar});
  return runtime::WorldRequest(runtime::PlaceRobot{robot(place), {pose[0], pose[1], pose[2]}});
}

ScenarioReader::Deed ScenarioReader::readPlaceBall(Config& place) {
  const Vec3 v_W = place.has("velocity") ? vectorWithin(place, "velocity", 100) : Vec3(0, 0, 0);
  return runtime::WorldRequest(
      runtime::PlaceBall{ball(place), vectorWithin(place, "position", kFar), v_W});
}

std::string ScenarioReader::sensor(Config& entry, std::size_t robot) {
  const std::string name = entry.text("sensor");
  const auto names = sim::Faults::sensorNames(*scenario_.models[robot]);
  if (std::count(names.begin(), names.end(), name)) return name;
  entry.reject("sensor", "a joint of " + nameOf(robot) +
                             ", Accelerometer, Gyroscope, Angles, LFoot/FSR, RFoot/FSR or Sonar");
}

ScenarioReader::Deed ScenarioReader::readKill(Config& kill) {
  const std::size_t who = robot(kill);
  return runtime::WorldRequest(runtime::KillJoint{who, joint(kill, who), lengthOf(kill)});
}

ScenarioReader::Deed ScenarioReader::readFreeze(Config& freeze) {
  const std::size_t who = robot(freeze);
  return runtime::WorldRequest(runtime::FreezeSensor{who, sensor(freeze, who), lengthOf(freeze)});
}

ScenarioReader::Deed ScenarioReader::readNoise(Config& noise) {
  const std::size_t who = robot(noise);
  return runtime::WorldRequest(runtime::DisturbSensor{
      who, sensor(noise, who), noise.number("sd", kPositive), lengthOf(noise)});
}

ScenarioReader::Deed ScenarioReader::readHeat(Config& heat) {
  const std::size_t who = robot(heat);
  return runtime::WorldRequest(
      runtime::HeatMotor{who, joint(heat, who), heat.number("temperature", kTemperature)});
}

ScenarioReader::Deed ScenarioReader::readBattery(Config& battery) {
  return runtime::WorldRequest(
      runtime::SetCharge{robot(battery), battery.number("charge", {0, 1})});
}

ScenarioReader::Deed ScenarioReader::readLens(Config& lens) {
  const std::size_t who = robot(lens);
  return runtime::WorldRequest(
      runtime::DirtyLens{who, camera(lens, who), lens.number("dirt", {0, 1})});
}

ScenarioReader::Deed ScenarioReader::readWet(Config& wet) {
  const auto center = wet.numbers("center", 2, {-kFar, kFar});
  return runtime::WorldRequest(runtime::WetFloor{center[0], center[1],
                                                 wet.number("radius", kPositive),
                                                 wet.number("friction", {0, 2}), lengthOf(wet)});
}

ScenarioReader::Deed ScenarioReader::readWire(Config& wire) {
  DisturbWire fault{robot(wire), fromSeconds(wire.number("delay", {0, 60}, 0)),
                    wire.number("loss", {0, 0.9}, 0), lengthOf(wire)};
  if (fault.delay == Duration::zero() && fault.loss == 0) wire.fail("expected delay or loss");
  return fault;
}

void ScenarioReader::readEvents(Config& file) {
  struct Kind {
    const char* name;
    Deed (ScenarioReader::*read)(Config&);
  };
  static constexpr Kind kKinds[] = {{"push", &ScenarioReader::readPush},
                                    {"press", &ScenarioReader::readPress},
                                    {"place_robot", &ScenarioReader::readPlaceRobot},
                                    {"place_ball", &ScenarioReader::readPlaceBall},
                                    {"kill_joint", &ScenarioReader::readKill},
                                    {"freeze", &ScenarioReader::readFreeze},
                                    {"noise", &ScenarioReader::readNoise},
                                    {"heat", &ScenarioReader::readHeat},
                                    {"battery", &ScenarioReader::readBattery},
                                    {"dirty_lens", &ScenarioReader::readLens},
                                    {"wet_floor", &ScenarioReader::readWet},
                                    {"wire", &ScenarioReader::readWire}};
  std::vector<std::string> known;
  for (const Kind& kind : kKinds) known.emplace_back(kind.name);
  file.list("events", Presence::Optional, [&](Config& entry) {
    const std::string about = kindOf(entry, {"at"}, known);
    Event event{moment(entry, "at"), {}, about};
    const auto kind = std::find(known.begin(), known.end(), about) - known.begin();
    entry.map(about, Presence::Required,
              [&](Config& details) { event.deed = (this->*kKinds[kind].read)(details); });
    scenario_.events.push_back(std::move(event));
  });
  std::stable_sort(scenario_.events.begin(), scenario_.events.end(),
                   [](const Event& one, const Event& other) { return one.at < other.at; });
}

}  // namespace nao::ci
