#include "app/hand_over.h"

#include <unistd.h>

#include <filesystem>

#include "core/check.h"

namespace nao::app {

void handOver(const std::string& program, const std::vector<std::string>& arguments,
              const std::string& what) {
  const auto file = std::filesystem::canonical("/proc/self/exe").parent_path() / program;
  if (!std::filesystem::exists(file)) {
    throw InputError(what + " hides effects in sets, which only tests may: build " + file.string() +
                     " (with NAO_TESTS, as by default)");
  }
  const std::string path = file.string();
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(path.c_str(), words.data());
  throw InputError(path + ": cannot be started");
}

}  // namespace nao::app
