#pragma once

#include <string>
#include <vector>

#include "validation/log/convert.h"
#include "validation/log/memory_columns.h"

// One function per format of convert.h, and what they share.
namespace nao::validation {

LogSet convertBam(const std::string& from);
LogSet convertPoppy(const std::string& from);
LogSet convertMemory(const std::string& from);
LogSet convertLola(const std::string& from);

/// The file itself, or the data files of a folder in order of their names; at least one.
std::vector<std::string> listLogFiles(const std::string& from);
/// Lists every joint that a column names.
void addJoints(LogSet& set);
/// [Hz] mean over all runs.
double calcRate(const LogSet& set);

}  // namespace nao::validation
