#pragma once

#include <string>

#include "validation/log/robot_log.h"

// The two kinds of files that a set consists of.
namespace nao::validation {

/// A set without the rows of its runs, from the text of meta.json; `file` is for errors.
LogSet parseMeta(const std::string& text, const std::string& file);
std::string formatMeta(const LogSet& set);

/// Fills in the rows of `run` from the text of its CSV file. Columns must be known signals, those
/// of joints must name joints of `set`.
void parseRows(const std::string& text, const std::string& file, const LogSet& set, LogRun& run);
std::string formatRows(const LogRun& run);

/// What is wrong with this name of a column, as "expected ..."; empty: nothing.
std::string findColumnFault(const std::string& name, const LogSet& set);

/// A whole file, unpacked if it is gzipped. @throws InputError if there is none.
std::string readPacked(const std::string& file);

}  // namespace nao::validation
