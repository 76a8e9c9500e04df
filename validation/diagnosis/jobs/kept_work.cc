#include "validation/diagnosis/jobs/kept_work.h"

#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "core/check.h"
#include "core/files.h"

namespace nao::validation {
namespace {

namespace fs = std::filesystem;

constexpr char kKey[] = "key";
constexpr char kEnding[] = ".unit";
const std::string kWhole = "\nwhole\n";  // what a file ends with that was not cut off

}  // namespace

KeptWork::KeptWork(std::string folder, const std::string& key) : folder_(std::move(folder)) {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  const std::optional<std::string> before = find(kKey);
  if (before) found_ = *before == key ? Found::Same : Found::Other;
  if (found_ == Found::Other) {
    for (const fs::path& file : listReadable(folder_)) {
      if (file.extension() == kEnding) fs::remove(file, failed);
    }
  }
  if (found_ != Found::Same) keep(kKey, key);
}

std::string KeptWork::fileOf(const std::string& unit) const {
  std::string name = part_ + unit;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-') c = '_';
  }
  return (fs::path(folder_) / (name + kEnding)).string();
}

std::optional<std::string> KeptWork::find(const std::string& unit) const {
  if (!keeps()) return std::nullopt;
  std::ifstream in(fileOf(unit), std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(in), {}};
  const std::size_t size = content.size() - std::min(content.size(), kWhole.size());
  if (content.size() < kWhole.size() || content.substr(size) != kWhole) return std::nullopt;
  content.resize(size);
  return content;
}

void KeptWork::keep(const std::string& unit, const std::string& content) const {
  if (!keeps()) return;
  const std::string file = fileOf(unit);
  std::ostringstream unfinished_name;  // of this thread alone
  unfinished_name << file << '.' << ::getpid() << '.' << std::this_thread::get_id();
  const std::string unfinished = unfinished_name.str();
  writeFile("", unfinished, content + kWhole);
  std::error_code failed;
  fs::rename(unfinished, file, failed);
  if (failed) throw InputError(file + ": can not be written");
}

std::string KeptWork::remember(const std::string& unit,
                               const std::function<std::string()>& work) const {
  if (std::optional<std::string> before = find(unit)) return *before;
  std::string content = work();
  keep(unit, content);
  return content;
}

KeptWork KeptWork::part(const std::string& name) const {
  KeptWork named = *this;
  named.part_ += name + ".";
  return named;
}

void KeptWork::discard() const {
  std::error_code ignored;
  if (keeps()) fs::remove_all(folder_, ignored);
}

}  // namespace nao::validation
