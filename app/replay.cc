#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/diagnosis/replay_set.h"
#include "validation/log/error_map.h"

namespace nao::app {
namespace {

struct Options {
  std::string set, model;
  validation::ReplayOptions replay;
  bool json = false;
};

void run(const Options& options) {
  const validation::LogSet set = validation::readLogSet(options.set);
  const std::string name = options.model.empty() ? set.robot : options.model;
  const std::string robots = findSourceFile("robots");
  // Of a robot without a model the error map is of command against sensor.
  const bool known = std::filesystem::is_directory(robots + "/" + name);
  if (!known && options.model.empty())
    std::fprintf(stderr, "no robot '%s' is known\n", name.c_str());
  const validation::Report report =
      known || !options.model.empty()
          ? validation::replaySet(set, loadRobotModel(robots, name), options.replay)
          : validation::reportErrorMap(set);
  const std::string text = options.json ? toJson(report) + "\n" : toText(report);
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "replay",
      "Replays the commands of a recorded set on a model: what the simulation gets wrong.\n"
      "Of a robot without a model: how its joints follow, and left against right.");
  const auto options = std::make_shared<Options>();
  command->add_option("set", options->set, "Folder of the set (RobotLog 1).")->required();
  command->add_option("--model", options->model, "A robot of robots/; default: the set's own.");
  command->add_option("--runs", options->replay.runs, "Simulated runs per motion.")
      ->check(CLI::Range(2, 1000));
  command->add_option("--jobs", options->replay.jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "One JSON object instead of text.");
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
