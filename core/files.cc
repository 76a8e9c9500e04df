#include "core/files.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <type_traits>

#include "core/check.h"

namespace nao {
namespace {

namespace fs = std::filesystem;

void put(const std::string& option, const std::string& file, const std::string& text,
         std::ios::openmode mode) {
  std::ofstream out(file, std::ios::binary | mode);
  if ((out << text).flush()) return;
  throw InputError((option.empty() ? "" : option + " ") + file + ": the file can not be written");
}

constexpr auto kAll = fs::directory_options::none;
constexpr auto kReadable = fs::directory_options::skip_permission_denied;

// The iterators of the library throw at an increment, whatever their constructor was told.
template <class Iterator>
std::vector<fs::path> list(const fs::path& folder, fs::directory_options which,
                           std::error_code& failed) {
  constexpr bool kFilesAlone = std::is_same_v<Iterator, fs::recursive_directory_iterator>;
  std::vector<fs::path> found;
  std::error_code gone;
  for (Iterator at(folder, which, failed); !failed && at != Iterator(); at.increment(failed)) {
    if (!kFilesAlone || at->is_regular_file(gone)) found.push_back(at->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

template <class Iterator>
std::vector<fs::path> listAll(const fs::path& folder) {
  std::error_code failed;
  std::vector<fs::path> found = list<Iterator>(folder, kAll, failed);
  if (failed) throw InputError(folder.string() + ": expected a folder that can be read");
  return found;
}

template <class Iterator>
std::vector<fs::path> listSome(const fs::path& folder) {
  std::error_code ignored;
  return list<Iterator>(folder, kReadable, ignored);
}

}  // namespace

void writeFile(const std::string& option, const std::string& file, const std::string& text) {
  put(option, file, text, std::ios::trunc);
}

void appendToFile(const std::string& option, const std::string& file, const std::string& text) {
  put(option, file, text, std::ios::app);
}

std::vector<fs::path> listFolder(const fs::path& folder) {
  return listAll<fs::directory_iterator>(folder);
}

std::vector<fs::path> listReadable(const fs::path& folder) {
  return listSome<fs::directory_iterator>(folder);
}

std::vector<fs::path> listFilesBelow(const fs::path& folder) {
  return listAll<fs::recursive_directory_iterator>(folder);
}

std::vector<fs::path> listReadableBelow(const fs::path& folder) {
  return listSome<fs::recursive_directory_iterator>(folder);
}

}  // namespace nao
