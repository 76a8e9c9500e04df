#include "validation/log/robot_log.h"

#include <filesystem>

#include "core/check.h"
#include "core/files.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {
const char* nameOf(Split split) {
  switch (split) {
    case Split::Fit:
      return "fit";
    case Split::Select:
      return "select";
    case Split::Test:
      return "test";
  }
  return "";
}

const Column* LogRun::find(const std::string& name) const {
  const auto found = columns.find(name);
  return found == columns.end() ? nullptr : &found->second;
}

void requireRuns(const LogSet& set, const std::vector<Split>& splits) {
  std::string expected;
  for (const Split split : splits) {
    for (const LogRun& run : set.runs) {
      if (run.split == split) return;
    }
    expected += std::string(expected.empty() ? "" : " or ") + nameOf(split);
  }
  throw InputError(set.name + ": expected at least one run with the split " + expected);
}

LogSet readLogSet(const std::string& folder) {
  const std::string meta = folder + "/meta.json";
  LogSet set = parseMeta(readPacked(meta), meta);
  for (LogRun& run : set.runs) {
    const std::string file = folder + "/" + run.file;
    parseRows(readPacked(file), file, set, run);
  }
  return set;
}

void writeLogSet(const LogSet& set, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder + ": the folder can not be made: " + error.message());
  writeFile("", folder + "/meta.json", formatMeta(set));
  for (const LogRun& run : set.runs) writeFile("", folder + "/" + run.file, formatRows(run));
}

}  // namespace nao::validation
