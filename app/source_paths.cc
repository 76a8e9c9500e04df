#include "app/source_paths.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/check.h"

namespace nao::app {

std::string findSourceFile(const std::string& path) {
  namespace fs = std::filesystem;
  if (fs::exists(path) || fs::path(path).is_absolute()) return path;
  const fs::path shipped = fs::path(NAO_SOURCE_DIR) / path;
  return fs::exists(shipped) ? shipped.string() : path;
}

std::string findMotionFile(const std::string& name, const std::string& robot) {
  namespace fs = std::filesystem;
  if (fs::exists(name)) return name;
  std::vector<fs::path> shipped;
  for (const std::string& folder : {"robots/" + robot + "/motions", std::string("robots/motions"),
                                    std::string("examples/motions")}) {
    const fs::path place = fs::path(NAO_SOURCE_DIR) / folder;
    if (!fs::is_directory(place)) continue;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(place)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    shipped.insert(shipped.end(), files.begin(), files.end());
  }
  std::string known;
  for (const fs::path& file : shipped) {
    if (file.stem() == name || file.filename() == name) return file.string();
    known += " " + file.stem().string();
  }
  throw InputError(name + ": no such file, nor a motion of that name here:" + known);
}

}  // namespace nao::app
