#include "app/source_paths.h"

#include <filesystem>

namespace nao::app {

std::string findSourceFile(const std::string& path) {
  namespace fs = std::filesystem;
  if (fs::exists(path) || fs::path(path).is_absolute()) return path;
  const fs::path shipped = fs::path(NAO_SOURCE_DIR) / path;
  return fs::exists(shipped) ? shipped.string() : path;
}

}  // namespace nao::app
