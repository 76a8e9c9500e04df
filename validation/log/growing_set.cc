#include "validation/log/growing_set.h"

#include <filesystem>
#include <utility>

#include "core/check.h"
#include "core/files.h"
#include "validation/log/robot_log_files.h"

namespace nao::validation {

void requireNoSet(const std::string& folder) {
  std::error_code error;
  if (std::filesystem::exists(folder + "/meta.json", error)) {
    throw InputError(folder + ": expected a folder without a set, found meta.json of another");
  }
}

GrowingSet::GrowingSet(LogSet set, std::string folder)
    : set_(std::move(set)), folder_(std::move(folder)) {
  requireNoSet(folder_);
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw InputError(folder_ + ": the folder can not be made: " + error.message());
}

// The list is put in place whole: who reads it meanwhile, or after a crash, finds one or the other.
void GrowingSet::add(LogRun run) {
  writeFile("", folder_ + "/" + run.file, formatRows(run));
  run.t.clear();
  run.columns.clear();
  LogSet grown = set_;
  grown.runs.push_back(std::move(run));
  const std::string fresh = folder_ + "/meta.json.new";
  writeFile("", fresh, formatMeta(grown));
  std::filesystem::rename(fresh, folder_ + "/meta.json");
  set_ = std::move(grown);
}

}  // namespace nao::validation
