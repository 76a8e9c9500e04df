#include "validation/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/check.h"

namespace nao::validation {
namespace {

using Json = nlohmann::ordered_json;

Json toValue(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }
Json toValue(const std::string& text) { return text; }
Json toValue(const std::vector<double>& numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(toValue(number));
  return list;
}
Json toValue(const Statistics& s) {
  return {{"mean", toValue(s.mean)},
          {"sd", toValue(s.sd)},
          {"min", toValue(s.min)},
          {"max", toValue(s.max)},
          {"n", s.n}};
}
Json toValue(const Row& row) {
  Json object = Json::object();
  for (const auto& [name, cell] : row) {
    object[name] = std::visit([](const auto& value) { return toValue(value); }, cell);
  }
  return object;
}
Json toValue(const std::vector<Row>& rows) {
  Json list = Json::array();
  for (const Row& row : rows) list.push_back(toValue(row));
  return list;
}

std::string hexOf(std::uint64_t hash) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

// Letters shown, not bytes: a byte 10xxxxxx of UTF-8 continues the letter before it.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<std::size_t> columnWidths(const TextTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& title : table.head) widths.push_back(widthOf(title));
  for (const auto& line : table.lines) {
    NAO_CHECK(line.size() <= widths.size());
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], widthOf(line[i]));
  }
  return widths;
}

// The first column stands to the left, numbers to the right.
void appendLine(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                std::string& out) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string padding(widths[i] - widthOf(cells[i]), ' ');
    line += i == 0 ? "  " + cells[i] + padding : "  " + padding + cells[i];
  }
  out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

}  // namespace

Statistics calcStatistics(const std::vector<double>& values) {
  NAO_CHECK(!values.empty());
  Statistics s;
  s.n = values.size();
  s.min = *std::min_element(values.begin(), values.end());
  s.max = *std::max_element(values.begin(), values.end());
  const double n = static_cast<double>(s.n);
  for (const double value : values) s.mean += value / n;
  double squares = 0;
  for (const double value : values) squares += (value - s.mean) * (value - s.mean);
  s.sd = s.n > 1 ? std::sqrt(squares / (n - 1)) : 0;
  return s;
}

std::string toJson(const Report& report) {
  Json figures = Json::object();
  for (const Figure& figure : report.figures) {
    figures[figure.name] =
        std::visit([](const auto& value) { return toValue(value); }, figure.value);
  }
  Json out = {{"command", report.command}, {"robot", report.robot},   {"seed", report.seed},
              {"runs", report.runs},       {"step_s", report.step_s}, {"hash", hexOf(report.hash)},
              {"figures", figures}};
  if (!report.draw.empty()) out["draw"] = report.draw;
  return out.dump();
}

std::string toText(const Report& report) {
  std::string out;
  for (const TextTable& table : report.tables) {
    out += table.title + "\n";
    const std::vector<std::size_t> widths = columnWidths(table);
    appendLine(table.head, widths, out);
    for (const auto& line : table.lines) appendLine(line, widths, out);
    out += "\n";
  }
  for (const std::string& remark : report.remarks) out += remark + "\n";
  return out;
}

std::string fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::uint64_t combineHash(std::uint64_t hash, std::uint64_t next) {
  constexpr std::uint64_t kFnvPrime = 1099511628211ULL;
  return (hash ^ next) * kFnvPrime;
}

}  // namespace nao::validation
