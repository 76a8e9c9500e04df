#include "naoqi_api/services/data_files.h"

#include <fstream>
#include <system_error>

#include "core/files.h"
#include "naoqi_api/call_error.h"

namespace nao::services {
namespace fs = std::filesystem;
using rpc::CallError;

namespace {

std::uintmax_t sizeOf(const fs::path& folder) {
  std::uintmax_t all = 0;
  for (const fs::path& file : listReadableBelow(folder)) {
    std::error_code gone;
    const std::uintmax_t size = fs::file_size(file, gone);
    if (!gone) all += size;
  }
  return all;
}

}  // namespace

fs::path dataPath(const fs::path& data_dir, const std::string& name) {
  if (data_dir.empty()) throw CallError("there is no place for files: serve --data-dir FOLDER");
  fs::path below = data_dir;
  for (const fs::path& part : fs::path(name).relative_path()) {
    if (part == ".." || part.native().find('\0') != std::string::npos) {
      throw CallError("the file name leads out of the data directory: " + name);
    }
    below /= part;
    std::error_code failed;
    if (fs::is_symlink(below, failed)) throw CallError("a link is not followed: " + name);
  }
  return below;
}

std::optional<fs::path> findDataFile(const fs::path& data_dir, const std::string& name) {
  if (data_dir.empty()) return std::nullopt;
  const fs::path file = dataPath(data_dir, name);
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return std::nullopt;
  return file;
}

void writeDataFile(const fs::path& data_dir, const std::string& name, const std::string& content) {
  const fs::path file = dataPath(data_dir, name);
  if (sizeOf(data_dir) + content.size() > kDataQuota) throw CallError("the data directory is full");
  std::error_code failed;
  fs::create_directories(file.parent_path(), failed);
  std::ofstream stream(file, std::ios::binary);
  stream << content;
  if (!stream.flush()) throw CallError("the file can not be written: " + name);
}

}  // namespace nao::services
