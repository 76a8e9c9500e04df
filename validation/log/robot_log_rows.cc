// The rows of a run:
//   file = header { row }       lines end in "\n" or "\r\n"
//   header = "t" { "," column }
//   row = time { "," [ number ] }   as many cells as the header; an empty cell was not sampled
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <string_view>

#include "core/check.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
namespace {

using std::string_view;

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

string_view takeLine(string_view& text) {
  const std::size_t end = text.find('\n');
  string_view line = text.substr(0, end);
  text.remove_prefix(end == string_view::npos ? text.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::vector<string_view> split(string_view line) {
  std::vector<string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

// The header is row 1, as an editor counts.
struct Place {
  const std::string& file;
  std::size_t row;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file + ": row " + std::to_string(row) + ": " + what);
  }
  [[noreturn]] void fail(const std::string& column, const std::string& expected,
                         string_view found) const {
    fail("column " + column + ": expected " + expected + ", found '" + std::string(found) + "'");
  }
};

std::vector<std::string> parseHeader(string_view line, const Place& place, const LogSet& set) {
  std::vector<std::string> names;
  for (const string_view cell : split(line)) names.emplace_back(cell);
  if (names.front() != "t") place.fail("1", "t, the time in seconds", names.front());
  for (std::size_t i = 1; i < names.size(); ++i) {
    const std::string fault = findColumnFault(names[i], set);
    if (!fault.empty()) place.fail(std::to_string(i + 1), fault, names[i]);
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      place.fail(std::to_string(i + 1), "every column once", names[i]);
    }
  }
  return names;
}

double parseCell(string_view cell, const std::string& column, const Place& place) {
  if (cell.empty() && column != "t") return kUnknown;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    place.fail(column, column == "t" ? "a number" : "a number or an empty cell", cell);
  }
  return value;
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
  string_view rest = text;
  Place place{file, 1};
  const std::vector<std::string> names = parseHeader(takeLine(rest), place, set);
  std::vector<Column> columns(names.size());
  while (!rest.empty()) {
    ++place.row;
    const std::vector<string_view> cells = split(takeLine(rest));
    if (cells.size() != names.size()) {
      place.fail("expected " + std::to_string(names.size()) + " cells as in the header, found " +
                 std::to_string(cells.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      columns[i].push_back(parseCell(cells[i], names[i], place));
    }
  }
  if (columns.front().empty()) place.fail("expected rows below the header, found none");
  run.t = std::move(columns.front());
  run.columns.clear();
  for (std::size_t i = 1; i < names.size(); ++i) run.columns[names[i]] = std::move(columns[i]);
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
