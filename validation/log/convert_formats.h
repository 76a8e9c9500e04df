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

/// The file itself, or the files of a folder in order of their names; at least one. Of a folder
/// that has JSON or CSV files, these alone.
std::vector<std::string> listLogFiles(const std::string& from);
/// Each run is a motion of its own: the last one is for the test, the one before to select.
void splitByOrder(LogSet& set);
/// The name of a file without folder and endings.
std::string stemOf(const std::string& file);
/// Lists every joint that a column names.
void addJoints(LogSet& set);
/// [Hz] mean over all runs.
double calcRate(const LogSet& set);

}  // namespace nao::validation
