#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "core/check.h"

namespace nao::app {
namespace {

// Hands over to the program that stands beside this one.
[[noreturn]] void become(const std::vector<std::string>& arguments) {
  const auto program =
      std::filesystem::canonical("/proc/self/exe").parent_path() / "usarnaoqi-bench-diagnosis";
  if (!std::filesystem::exists(program)) {
    throw InputError("bench diagnosis hides effects in sets, which only tests may: build " +
                     program.string() + " (with NAO_TESTS, as by default)");
  }
  const std::string path = program.string();
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execv(path.c_str(), words.data());
  throw InputError(path + ": cannot be started");
}

}  // namespace

void addBench(CLI::App& app) {
  CLI::App* bench = app.add_subcommand("bench", "Puts a part of the program on trial.");
  bench->require_subcommand(1);
  CLI::App* diagnosis = bench->add_subcommand(
      "diagnosis",
      "Hides effects in simulated sets and counts what `diagnose` finds. Options are those of\n"
      "usarnaoqi-bench-diagnosis: --preset quick, standard or full, --seed, --shard i/n, --out "
      "...");
  diagnosis->prefix_command();
  diagnosis->callback([diagnosis] { become(diagnosis->remaining()); });
}

}  // namespace nao::app
