// The frames of a NAO V6's socket (LoLA), as they follow each other there: sensor frames, which
// have `Angles`, and between them the actuator frames that answer, if they were recorded too. No
// frame has a time: the robot sends one every 12 ms.
#include <array>
#include <sstream>

#include "core/check.h"
#include "core/lola_joints.h"
#include "validation/log/convert_formats.h"
#include "validation/log/json_map.h"
#include "validation/log/lola_rows.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

using Json = nlohmann::json;

constexpr double kCycle = 0.012;          // [s]
constexpr double kNewtonPerKg = 9.80665;  // force sensors are in kg of weight

constexpr std::array kForces{"L.fl", "L.fr", "L.rl", "L.rr", "R.fl", "R.fr", "R.rl", "R.rr"};
constexpr std::array kAxes{"x", "y", "z"};

void put(LogRun& run, const std::string& column, const Json& value, double scale) {
  Column& values = run.columns[column];
  values.resize(run.t.size(), kUnknown);
  values.back() = value.is_number() ? scale * value.get<double>() : kUnknown;
}

template <class Names>
void putAll(LogRun& run, const Json& frame, const char* key, const std::string& signal,
            const Names& names, double scale = 1) {
  const auto list = frame.find(key);
  if (list == frame.end() || !list->is_array()) return;
  for (std::size_t i = 0; i < names.size() && i < list->size(); ++i) {
    put(run, signal + names[i], (*list)[i], scale);
  }
}

void addSensors(LogRun& run, const Json& frame) {
  run.t.push_back(static_cast<double>(run.t.size()) * kCycle);
  putAll(run, frame, "Position", "q.", lolaJoints());
  putAll(run, frame, "Current", "cur.", lolaJoints());
  putAll(run, frame, "Temperature", "temp.", lolaJoints());
  putAll(run, frame, "Accelerometer", "imu.acc.", kAxes);
  putAll(run, frame, "Gyroscope", "imu.gyr.", kAxes);
  putAll(run, frame, "Angles", "imu.ang.", kAxes);
  putAll(run, frame, "FSR", "fsr.", kForces, kNewtonPerKg);
}

void addCommand(LogRun& run, const Json& frame) {
  if (run.t.empty()) return;
  putAll(run, frame, "Position", "cmd.", lolaJoints());
  putAll(run, frame, "Stiffness", "cmd_stiffness.", lolaJoints());
}

}  // namespace

const std::vector<std::string>& lolaJoints() {
  static const std::vector<std::string> kJoints(kLolaJoints.begin(), kLolaJoints.end());
  return kJoints;
}

std::vector<double> readLolaAngles(const std::string& frame) {
  const Json json = Json::from_msgpack(frame, true, false);
  const auto list = json.is_object() ? json.find("Position") : json.end();
  if (!json.is_object() || list == json.end() || list->size() != lolaJoints().size()) {
    throw InputError("LoLA: expected a sensor frame with 25 positions, found other bytes");
  }
  return list->get<std::vector<double>>();
}

std::string encodeLolaCommand(const std::vector<double>& angles,
                              const std::vector<double>& stiffness) {
  NAO_CHECK(angles.size() == lolaJoints().size() && stiffness.size() == angles.size());
  // As the robot's clients do: numbers of 32 bits.
  const auto narrow = [](const std::vector<double>& values) {
    return std::vector<float>(values.begin(), values.end());
  };
  const Json frame{{"Position", narrow(angles)}, {"Stiffness", narrow(stiffness)}};
  const std::vector<std::uint8_t> bytes = Json::to_msgpack(frame);
  return std::string(bytes.begin(), bytes.end());
}

LogRun readLolaRows(const std::string& bytes, const std::string& file) {
  LogRun run;
  std::istringstream in(bytes);
  while (in.peek() != std::char_traits<char>::eof()) {
    const auto place = std::to_string(in.tellg());
    const Json frame = Json::from_msgpack(in, false, false);
    if (!frame.is_object()) {
      throw InputError(file + ": byte " + place + ": expected a whole MessagePack map, found none");
    }
    if (frame.contains("Angles")) {
      addSensors(run, frame);
    } else {
      addCommand(run, frame);
    }
  }
  if (run.t.empty()) throw InputError(file + ": expected sensor frames, found none");
  for (auto& [name, values] : run.columns) values.resize(run.t.size(), kUnknown);
  return run;
}

LogSet convertLola(const std::string& from) {
  LogSet set;
  set.name = "LoLA frames";
  set.source = "converted from LoLA frames";
  set.robot = "nao_h25_v60";
  set.clock = {"robot", "sent", "measured"};
  set.rate = 1 / kCycle;
  for (const std::string& file : listLogFiles(from)) {
    LogRun& run = set.runs.emplace_back(readLolaRows(readPacked(file), file));
    run.motion = stemOf(file);
    run.file = "run_" + run.motion + ".csv";
  }
  splitByOrder(set);
  addJoints(set);
  return set;
}

}  // namespace nao::validation
