// CSV files of others: Poppy's in degrees, and logs of NAOqi's ALMemory keys.
#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/log/convert_formats.h"
#include "validation/log/csv_table.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

constexpr double kRadian = 0.017453292519943295;  // [rad] of a degree

struct Signal {
  std::string prefix;  // of the file's column
  std::string column;  // of ours
  double scale;
};

// Other columns (load in percent) have no place in RobotLog 1.
const std::vector<Signal>& poppySignals() {
  static const std::vector<Signal> kSignals{{"position.", "q.", kRadian},
                                            {"target.", "cmd.", kRadian},
                                            {"speed.", "qd.", kRadian},
                                            {"temperature.", "temp.", 1}};
  return kSignals;
}

std::string ourPoppyColumn(const std::string& name, double& scale) {
  for (const Signal& signal : poppySignals()) {
    if (name.rfind(signal.prefix, 0) != 0) continue;
    scale = signal.scale;
    return signal.column + name.substr(signal.prefix.size());
  }
  return {};
}

CsvTable readTable(const std::string& file) {
  return parseCsv(readPacked(file), file,
                  [](const std::string&, std::size_t) { return std::string(); });
}

const std::vector<double>& need(const CsvTable& table, const std::string& name,
                                const std::string& file) {
  const std::vector<double>* column = table.find(name);
  if (!column) throw InputError(file + ": row 1: expected a column " + name + ", found none");
  return *column;
}

Column cut(const std::vector<double>& values, std::size_t from, std::size_t to, double scale) {
  Column part;
  for (std::size_t i = from; i < to; ++i) part.push_back(scale * values[i]);
  return part;
}

LogRun cutSegment(const CsvTable& table, const std::vector<double>& t, std::size_t from,
                  std::size_t to, std::size_t number) {
  LogRun run;
  run.motion = "segment_" + std::to_string(number);
  run.file = run.motion + ".csv";
  run.t = cut(t, from, to, 1);
  for (double& time : run.t) time -= t[from];
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    double scale = 1;
    const std::string name = ourPoppyColumn(table.names[c], scale);
    if (!name.empty()) run.columns[name] = cut(table.columns[c], from, to, scale);
  }
  return run;
}

LogRun memoryRun(const std::string& file) {
  const CsvTable table = readTable(file);
  LogRun run;
  run.motion = stemOf(file);
  run.file = "run_" + run.motion + ".csv";
  run.t = table.columns.front();
  for (double& time : run.t) time -= table.columns.front().front();
  for (std::size_t c = 1; c < table.names.size(); ++c) {
    const auto found = findMemoryColumn(table.names[c]);
    if (found) run.columns[found->column] = cut(table.columns[c], 0, run.t.size(), found->scale);
  }
  if (run.columns.empty()) {
    throw InputError(file +
                     ": row 1: expected keys such as "
                     "Device/SubDeviceList/HeadYaw/Position/Sensor/Value, found none");
  }
  return run;
}

}  // namespace

LogSet convertPoppy(const std::string& from) {
  const std::string file = listLogFiles(from).front();
  const CsvTable table = readTable(file);
  const std::vector<double>& segment = need(table, "segment", file);
  const std::vector<double>& t = need(table, "t", file);
  LogSet set;
  set.name = "Poppy, partly held";
  set.source = "converted from a Poppy log";
  set.robot = "poppy";
  set.clock = {"host", "sent", "received"};
  for (std::size_t begin = 0, i = 1; i <= t.size(); ++i) {
    if (i < t.size() && segment[i] == segment[begin]) continue;
    if (i - begin > 1) set.runs.push_back(cutSegment(table, t, begin, i, set.runs.size()));
    begin = i;
  }
  if (set.runs.empty()) throw InputError(file + ": expected segments of two rows or more");
  splitByOrder(set);
  addJoints(set);
  set.rate = calcRate(set);
  return set;
}

LogSet convertMemory(const std::string& from) {
  LogSet set;
  set.name = "ALMemory log";
  set.source = "converted from logs of ALMemory keys";
  set.robot = "nao_h21_v33";
  set.clock = {"host", "executed", "received"};
  for (const std::string& file : listLogFiles(from)) set.runs.push_back(memoryRun(file));
  splitByOrder(set);
  addJoints(set);
  const auto wrist = [](const LogJoint& joint) { return joint.name == "LWristYaw"; };
  if (std::any_of(set.joints.begin(), set.joints.end(), wrist)) set.robot = "nao_h25_v50";
  set.rate = calcRate(set);
  return set;
}

}  // namespace nao::validation
