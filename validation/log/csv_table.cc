#include "validation/log/csv_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/check.h"
#include "validation/log/robot_log.h"

namespace nao::validation {
namespace {

using std::string_view;

string_view takeLine(string_view& text) {
  const std::size_t end = text.find('\n');
  string_view line = text.substr(0, end);
  text.remove_prefix(end == string_view::npos ? text.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

string_view trimmed(string_view cell) {
  const std::size_t from = cell.find_first_not_of(' ');
  if (from == string_view::npos) return {};
  return cell.substr(from, cell.find_last_not_of(' ') + 1 - from);
}

std::vector<string_view> split(string_view line) {
  std::vector<string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
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

std::vector<std::string> parseHeader(string_view line, const Place& place,
                                     const JudgeColumn& judge) {
  std::vector<std::string> names;
  for (const string_view cell : split(line)) names.emplace_back(cell);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string fault = judge(names[i], i);
    if (!fault.empty()) place.fail(std::to_string(i + 1), fault, names[i]);
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i)) {
      place.fail(std::to_string(i + 1), "every column once", names[i]);
    }
  }
  return names;
}

double parseCell(string_view cell, bool is_first, const std::string& column, const Place& place) {
  if (cell.empty() && !is_first) return kUnknown;
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value)) {
    place.fail(column, is_first ? "a number" : "a number or an empty cell", cell);
  }
  return value;
}

}  // namespace

CsvTable parseCsv(const std::string& text, const std::string& file, const JudgeColumn& judge) {
  string_view rest = text;
  Place place{file, 1};
  CsvTable table;
  table.names = parseHeader(takeLine(rest), place, judge);
  table.columns.resize(table.names.size());
  while (!rest.empty()) {
    ++place.row;
    const std::vector<string_view> cells = split(takeLine(rest));
    if (cells.size() != table.names.size()) {
      place.fail("expected " + std::to_string(table.names.size()) +
                 " cells as in the header, found " + std::to_string(cells.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      table.columns[i].push_back(parseCell(cells[i], i == 0, table.names[i], place));
    }
  }
  if (table.columns.front().empty()) place.fail("expected rows below the header, found none");
  return table;
}

const std::vector<double>* CsvTable::find(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? nullptr : &columns[static_cast<std::size_t>(found - names.begin())];
}

}  // namespace nao::validation
