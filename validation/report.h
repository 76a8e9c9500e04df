#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nao::validation {

/// A number measured in several runs.
struct Statistics {
  double mean = 0;
  double sd = 0;  // of the sample, n - 1; 0 for a single run
  double min = 0;
  double max = 0;
  std::size_t n = 0;
};
/// Of at least one value.
Statistics calcStatistics(const std::vector<double>& values);

/// One line of a table in a figure: named cells, in order.
using Cell = std::variant<double, std::string, std::vector<double>>;
using Row = std::vector<std::pair<std::string, Cell>>;

/// A measured figure; its name ends in its unit. A plain number, statistics, numbers by name (of a
/// joint, say), or a table of rows.
struct Figure {
  std::string name;
  std::variant<double, Statistics, Row, std::vector<Row>> value;
};

/// A table for a person: every cell is text already.
struct TextTable {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> lines;
};

/// What a command that measures has to say, for programs (toJson) and for people (toText).
struct Report {
  std::string command;  // "experiment gravity"
  std::string robot;
  std::uint64_t seed = 0;
  int runs = 1;
  double step_s = 0.002;
  std::uint64_t hash = 0;              // of the final states: equal for equal runs
  std::map<std::string, double> draw;  // what the seed drew, by name
  std::vector<Figure> figures;         // for programs
  std::vector<TextTable> tables;       // for people
  std::vector<std::string> remarks;    // for people, one sentence each
};

/// One JSON object on one line; numbers that are not finite become null.
std::string toJson(const Report& report);

/// The tables and remarks, ready to be printed.
std::string toText(const Report& report);

/// `value` with so many digits after the point.
std::string fixed(double value, int digits);

/// `hash` carried on by another number; for runs of several worlds.
std::uint64_t combineHash(std::uint64_t hash, std::uint64_t next);

}  // namespace nao::validation
