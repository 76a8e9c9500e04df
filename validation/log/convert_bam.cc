// Runs of Rhoban's test bench (github.com/Rhoban/bam): one JSON object per file,
//   mass [kg], length [m], kp (firmware P gain), vin [V], motor, trajectory, entries [...]
// and in each entry timestamp [s], position, goal_position [rad], speed [rad/s], input_volts [V],
// temp [deg C], torque_enable. `load` is a register without a unit and is left out.
#include <filesystem>
#include <set>

#include "core/check.h"
#include "validation/log/convert_formats.h"
#include "validation/log/json_map.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

constexpr const char* kJoint = "pendulum";
constexpr double kNominalGain = 100;  // firmware P gain of robots/xl330_pendulum
constexpr double kMotorOff = -1;

nlohmann::json parseFile(const std::string& file) {
  try {
    return nlohmann::json::parse(readPacked(file));
  } catch (const nlohmann::json::parse_error&) {
    throw InputError(file + ": expected JSON, found a mistake in it");
  }
}

void addEntry(JsonMap& entry, LogRun& run) {
  const auto put = [&](const char* signal, double value) {
    run.columns[std::string(signal) + "." + kJoint].push_back(value);
  };
  run.t.push_back(entry.number("timestamp"));
  put("q", entry.number("position"));
  put("cmd", entry.number("goal_position"));
  put("qd", entry.number("speed", kUnknown));
  put("temp", entry.number("temp", kUnknown));
  put("cmd_stiffness", entry.flag("torque_enable", true) ? 1 : kMotorOff);
  run.columns["bat.v"].push_back(entry.number("input_volts", kUnknown));
}

LogRun convertFile(const std::string& file, double& gain) {
  const nlohmann::json json = parseFile(file);
  JsonMap map(json, file + ": top");
  gain = map.number("kp");
  if (!(gain > 0)) map.reject("kp", "a number above 0");
  LogRun run;
  const std::string name = map.text("trajectory") + "_kp" + std::to_string(static_cast<int>(gain));
  run.motion = name;
  run.kp_scale = gain / kNominalGain;
  run.robot_id = map.text("motor", "");
  run.notes = std::filesystem::path(file).filename().string();
  for (JsonMap& entry : map.list("entries")) addEntry(entry, run);
  if (run.t.size() < 2) map.reject("entries", "at least two entries");
  return run;
}

Split splitOf(double gain, const std::set<double>& gains) {
  if (gains.size() == 1) return Split::Test;
  return gain == *gains.begin() || gain == *gains.rbegin() ? Split::Fit : Split::Select;
}

}  // namespace

LogSet convertBam(const std::string& from) {
  LogSet set;
  set.name = "servo on a pendulum";
  set.source = "converted from BAM logs";
  set.robot = "xl330_pendulum";
  set.clock = {"host", "sent", "received"};
  set.environment.suspended = true;
  std::vector<double> gains;
  for (const std::string& file : listLogFiles(from)) {
    set.runs.push_back(convertFile(file, gains.emplace_back()));
  }
  const std::set<double> all(gains.begin(), gains.end());
  std::map<std::string, int> repeats;
  for (std::size_t i = 0; i < set.runs.size(); ++i) {
    LogRun& run = set.runs[i];
    run.repeat = repeats[run.motion]++;
    run.file = run.motion + "_" + std::to_string(run.repeat) + ".csv";
    run.split = splitOf(gains[i], all);
  }
  addJoints(set);
  set.rate = calcRate(set);
  return set;
}

}  // namespace nao::validation
