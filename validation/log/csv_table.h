#pragma once

#include <functional>
#include <string>
#include <vector>

namespace nao::validation {

/// Numbers in named columns. As text:
///   file = header { row }              lines end in "\n" or "\r\n"
///   header = name { "," name }         every name once
///   row = number { "," [ number ] }    as many cells as the header; an empty cell becomes a NaN
struct CsvTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  // all of one length, at least 1

  const std::vector<double>* find(const std::string& name) const;
};

/// What is wrong with the name of the column of this number, as "expected ..."; empty: nothing.
using JudgeColumn = std::function<std::string(const std::string& name, std::size_t column)>;

/// @throws InputError with file, row, column and what was expected.
CsvTable parseCsv(const std::string& text, const std::string& file, const JudgeColumn& judge);

}  // namespace nao::validation
