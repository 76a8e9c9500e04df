#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/check.h"
#include "validation/log/csv_table.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

// Signals of joints: "<signal>.<joint>".
constexpr std::array kJointSignals{"cmd", "cmd_stiffness", "q", "qd", "cur", "tau", "temp"};

// All other columns.
const std::set<std::string>& plainColumns() {
  static const std::set<std::string> kColumns = [] {
    std::set<std::string> names{"bat.v", "bat.i", "contact.L", "contact.R", "gt.base.yaw"};
    for (const char* axis : {"x", "y", "z"}) {
      for (const char* signal : {"imu.acc.", "imu.gyr.", "imu.ang.", "gt.base."}) {
        names.insert(std::string(signal) + axis);
      }
    }
    for (const char* part : {"qw", "qx", "qy", "qz"}) {
      names.insert(std::string("gt.base.") + part);
    }
    for (const char* cell : {"fl", "fr", "rl", "rr"}) {
      for (const char* foot : {"fsr.L.", "fsr.R."}) names.insert(std::string(foot) + cell);
    }
    return names;
  }();
  return kColumns;
}

void append(std::string& text, double value) {
  if (std::isnan(value)) return;
  std::array<char, 32> digits{};  // the shortest that reads back as the same number
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

struct GzFile {
  explicit GzFile(const std::string& name) : handle(gzopen(name.c_str(), "rb")) {}
  ~GzFile() {
    if (handle) gzclose(handle);
  }
  GzFile(const GzFile&) = delete;
  GzFile& operator=(const GzFile&) = delete;
  gzFile handle;
};

}  // namespace

std::string findColumnFault(const std::string& name, const LogSet& set) {
  if (plainColumns().count(name) > 0) return {};
  const std::size_t dot = name.find('.');
  const std::string signal = name.substr(0, dot);
  if (std::find(kJointSignals.begin(), kJointSignals.end(), signal) == kJointSignals.end() ||
      dot == std::string::npos) {
    return "a signal that docs/robot_log.md lists";
  }
  const std::string joint = name.substr(dot + 1);
  for (const LogJoint& known : set.joints) {
    if (known.name == joint) return {};
  }
  return "a joint that meta.json lists";
}

void parseRows(const std::string& text, const std::string& file, const LogSet& set, LogRun& run) {
  const auto judge = [&](const std::string& name, std::size_t column) -> std::string {
    if (column == 0) return name == "t" ? "" : "t, the time in seconds";
    return findColumnFault(name, set);
  };
  CsvTable table = parseCsv(text, file, judge);
  run.t = std::move(table.columns.front());
  run.columns.clear();
  for (std::size_t i = 1; i < table.names.size(); ++i) {
    run.columns[table.names[i]] = std::move(table.columns[i]);
  }
}

std::string formatRows(const LogRun& run) {
  std::string text = "t";
  for (const auto& [name, values] : run.columns) {
    NAO_CHECK(values.size() == run.t.size());
    text += "," + name;
  }
  text += "\n";
  for (std::size_t i = 0; i < run.t.size(); ++i) {
    append(text, run.t[i]);
    for (const auto& [name, values] : run.columns) {
      text += ",";
      append(text, values[i]);
    }
    text += "\n";
  }
  return text;
}

std::string readPacked(const std::string& file) {
  const GzFile in(file);
  if (!in.handle) throw InputError(file + ": expected a file, found none that can be read");
  std::string text;
  std::array<char, 1 << 16> piece{};
  for (;;) {
    const int count = gzread(in.handle, piece.data(), piece.size());
    if (count < 0) throw InputError(file + ": expected a whole gzip file, found a broken one");
    if (count == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace nao::validation
