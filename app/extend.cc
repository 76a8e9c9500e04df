#include "validation/diagnosis/extension.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"

namespace nao::app {
namespace {

struct Options {
  std::string report, model = "nao_h21_v33", robots_dir = "robots", name;
  std::vector<std::string> accept;
};

void run(const Options& options) {
  const std::string robots = findSourceFile(options.robots_dir);
  const auto model = loadRobotModel(robots, options.model);
  const std::string report = options.report + "/report.json";
  const auto causes = validation::acceptedEffects(report, options.accept, *model);
  const std::string file = validation::writeExtendedRobot(
      robots, options.name, *model, causes, "Accepted from the diagnosis in " + options.report);
  std::printf("%s: %s with %zu more effect%s\n", file.c_str(), options.model.c_str(), causes.size(),
              causes.size() == 1 ? "" : "s");
}

}  // namespace

void addExtend(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "extend", "Makes a robot of the nominal one and the causes that a diagnosis found.");
  command->add_option("dir", options->report, "What `diagnose --out` wrote.")->required();
  command->add_option("--accept", options->accept,
                      "Causes to accept, rivals too. Default: all that are named alone.");
  command->add_option("--model", options->model, "The nominal robot.")->capture_default_str();
  command->add_option("-o,--output", options->name, "Name of the new robot.")->required();
  command->add_option("--robots-dir", options->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
