#include <algorithm>
#include <cmath>
#include <set>

#include "core/check.h"
#include "validation/log/json_map.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "RobotLog 1";

Split parseSplit(JsonMap& map) {
  const std::string name = map.text("split");
  for (const Split split : {Split::Fit, Split::Select, Split::Test}) {
    if (name == nameOf(split)) return split;
  }
  map.reject("split", "fit, select or test");
}

LogJoint parseJoint(JsonMap& map) {
  LogJoint joint;
  joint.name = map.text("name");
  joint.sign = map.number("sign", 1);
  if (std::abs(joint.sign) != 1) map.reject("sign", "1 or -1");
  joint.zero = map.number("zero_rad", 0);
  joint.encoder_quantum = map.number("encoder_quantum_rad", kUnknown);
  joint.stiffness = map.number("stiffness", 1);
  joint.gear = map.number("gear", kUnknown);
  joint.kp = map.number("kp", kUnknown);
  joint.kd = map.number("kd", kUnknown);
  map.finish();
  return joint;
}

LogLoad parseLoad(JsonMap map) {
  LogLoad load;
  load.link = map.text("link");
  load.mass = map.number("mass_kg");
  const std::vector<double> centre = map.numbers("com_m", 3);
  load.p_BoBcm_B = {centre[0], centre[1], centre[2]};
  map.finish();
  return load;
}

// A name within the set's folder.
std::string parseFile(JsonMap& map) {
  const std::string file = map.text("file");
  if (file.empty() || file.front() == '.' || file.find('/') != std::string::npos) {
    map.reject("file", "the name of a file beside meta.json");
  }
  return file;
}

LogRun parseRun(JsonMap& map) {
  LogRun run;
  run.file = parseFile(map);
  run.motion = map.text("motion");
  run.repeat = map.integer("repeat", 0);
  run.robot_id = map.text("robot_id", "");
  run.split = parseSplit(map);
  run.start_pose = map.text("start_pose", "");
  run.notes = map.text("notes", "");
  run.kp_scale = map.number("kp_scale", 1);
  if (map.has("load")) run.load = parseLoad(map.map("load"));
  map.finish();
  return run;
}

void parseRobot(JsonMap map, LogSet& set) {
  set.robot = map.text("model");
  set.version = map.text("version", "");
  set.serial = map.text("serial", "");
  set.body_mass = map.number("body_mass_kg", kUnknown);
  set.model_sha256 = map.text("sha256", "");
  map.finish();
}

void parseClock(JsonMap map, LogSet& set) {
  set.clock.type = map.text("type", "");
  set.rate = map.number("rate_hz");
  if (!(set.rate > 0)) map.reject("rate_hz", "a number above 0");
  set.clock.command_stamp = map.text("command_stamp", "");
  set.clock.sensor_stamp = map.text("sensor_stamp", "");
  map.finish();
}

void parseEnvironment(JsonMap map, LogEnvironment& environment) {
  environment.floor = map.text("floor", "");
  environment.tilt = map.number("tilt_rad", kUnknown);
  environment.temperature = map.number("temperature_degc", kUnknown);
  environment.suspended = map.flag("suspended", false);
  map.finish();
}

void parseLists(JsonMap& map, LogSet& set) {
  std::set<std::string> names;
  for (JsonMap& joint : map.list("joints")) {
    set.joints.push_back(parseJoint(joint));
    if (!names.insert("joint " + set.joints.back().name).second)
      joint.reject("name", "every joint once");
  }
  for (JsonMap& run : map.list("runs")) {
    set.runs.push_back(parseRun(run));
    if (!names.insert("file " + set.runs.back().file).second) {
      run.reject("file", "every file once");
    }
  }
  if (set.runs.empty()) map.reject("runs", "at least one run");
}

nlohmann::json parse(const std::string& text, const std::string& file) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::string before = text.substr(0, error.byte);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    throw InputError(file + ":" + std::to_string(line) + ": expected JSON, found a mistake in it");
  }
}

// Unknown numbers and empty texts are left out.
void put(Json& json, const char* key, double value) {
  if (!std::isnan(value)) json[key] = value;
}
void put(Json& json, const char* key, const std::string& value) {
  if (!value.empty()) json[key] = value;
}

Json formatJoint(const LogJoint& joint) {
  Json json{{"name", joint.name}};
  json["sign"] = static_cast<int>(joint.sign);
  put(json, "zero_rad", joint.zero);
  put(json, "encoder_quantum_rad", joint.encoder_quantum);
  put(json, "gear", joint.gear);
  put(json, "kp", joint.kp);
  put(json, "kd", joint.kd);
  put(json, "stiffness", joint.stiffness);
  return json;
}

Json formatRun(const LogRun& run) {
  Json json{{"file", run.file}, {"motion", run.motion}, {"repeat", run.repeat}};
  put(json, "robot_id", run.robot_id);
  json["split"] = nameOf(run.split);
  put(json, "start_pose", run.start_pose);
  put(json, "notes", run.notes);
  if (run.kp_scale != 1) json["kp_scale"] = run.kp_scale;
  if (run.load) {
    const Vec3& centre = run.load->p_BoBcm_B;
    json["load"] = {{"link", run.load->link},
                    {"mass_kg", run.load->mass},
                    {"com_m", {centre.x(), centre.y(), centre.z()}}};
  }
  return json;
}

}  // namespace

LogSet parseMeta(const std::string& text, const std::string& file) {
  const nlohmann::json json = parse(text, file);
  JsonMap map(json, file + ": meta");
  if (map.text("format") != kFormat) map.reject("format", std::string("\"") + kFormat + "\"");
  LogSet set;
  set.name = map.text("name", "");
  set.source = map.text("source", "");
  set.licence = map.text("licence", "");
  parseRobot(map.map("robot"), set);
  parseClock(map.map("clock"), set);
  if (map.has("environment")) parseEnvironment(map.map("environment"), set.environment);
  parseLists(map, set);
  map.finish();
  return set;
}

std::string formatMeta(const LogSet& set) {
  Json json{{"format", kFormat}};
  put(json, "name", set.name);
  put(json, "source", set.source);
  put(json, "licence", set.licence);
  Json& robot = json["robot"] = {{"model", set.robot}};
  put(robot, "version", set.version);
  put(robot, "serial", set.serial);
  put(robot, "body_mass_kg", set.body_mass);
  put(robot, "sha256", set.model_sha256);
  Json& clock = json["clock"] = Json::object();
  put(clock, "type", set.clock.type);
  clock["rate_hz"] = set.rate;
  put(clock, "command_stamp", set.clock.command_stamp);
  put(clock, "sensor_stamp", set.clock.sensor_stamp);
  Json& environment = json["environment"] = Json::object();
  put(environment, "floor", set.environment.floor);
  put(environment, "tilt_rad", set.environment.tilt);
  put(environment, "temperature_degc", set.environment.temperature);
  environment["suspended"] = set.environment.suspended;
  json["joints"] = Json::array();
  for (const LogJoint& joint : set.joints) json["joints"].push_back(formatJoint(joint));
  json["runs"] = Json::array();
  for (const LogRun& run : set.runs) json["runs"].push_back(formatRun(run));
  return json.dump(2) + "\n";
}

}  // namespace nao::validation
