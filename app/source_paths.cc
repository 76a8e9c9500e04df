#include "app/source_paths.h"

#include <filesystem>
#include <vector>

#include "core/check.h"
#include "core/files.h"
#include "motion/timeline/motion_file.h"

namespace nao::app {

namespace {

namespace fs = std::filesystem;

// In order of their names; none if there is no such folder.
std::vector<fs::path> motionsIn(const std::string& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::path& entry : listFolder(folder)) {
    if (fs::is_directory(entry) || motion::isMotionFile(entry)) files.push_back(entry);
  }
  return files;
}

std::string stemsOf(const std::vector<fs::path>& files) {
  std::string names;
  for (const fs::path& file : files) names += " " + file.stem().string();
  return names;
}

}  // namespace

std::string findSourceFile(const std::string& path) {
  if (fs::exists(path) || fs::path(path).is_absolute()) return path;
  const fs::path shipped = fs::path(NAO_SOURCE_DIR) / path;
  return fs::exists(shipped) ? shipped.string() : path;
}

std::string findEncoder() {
  std::error_code unknown;
  const fs::path self = fs::read_symlink("/proc/self/exe", unknown);
  return (self.parent_path() / "usarnaoqi-encode").string();
}

std::vector<std::string> shippedMotions() {
  std::vector<std::string> folders;
  for (const char* folder : {"examples/motions", "motions"}) {
    const fs::path place = fs::path(NAO_SOURCE_DIR) / folder;
    if (fs::is_directory(place)) folders.push_back(place.string());
  }
  return folders;
}

std::string findMotionFile(const std::string& name, const std::string& robot) {
  if (fs::exists(name)) return name;
  std::vector<std::string> folders = shippedMotions();
  folders.push_back((fs::path(NAO_SOURCE_DIR) / "robots" / robot / "motions").string());
  std::vector<fs::path> shipped;
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    for (const fs::path& file : motionsIn(*folder)) {
      if (file.stem() == name || file.filename() == name) return file.string();
      shipped.push_back(file);
    }
  }
  std::vector<fs::path> alike;
  for (const fs::path& file : shipped) {
    if (!name.empty() && file.stem().string().rfind(name, 0) == 0) alike.push_back(file);
  }
  if (alike.size() == 1) return alike.front().string();
  if (!alike.empty()) throw InputError(name + ": several motions begin so:" + stemsOf(alike));
  throw InputError(name + ": no such file, nor a motion of that name here:" + stemsOf(shipped));
}

}  // namespace nao::app
