#include "validation/diagnosis/extend/optimise.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/diagnosis/extend/extension.h"
#include "validation/diagnosis/extend/whole_optimise.h"
#include "validation/diagnosis/replay/whole_simulator.h"
#include "validation/log/log_robots.h"

namespace nao::app {
namespace {

struct Options {
  std::string set, model, free, name, robot_id, robots_dir = "robots";
  validation::OptimiseOptions optimise;
  bool json = false;
};

void run(const Options& options) {
  const std::string robots = findSourceFile(options.robots_dir);
  const validation::LogSet set =
      validation::runsOfOne(validation::readLogSet(options.set), options.robot_id);
  requireRuns(set, {validation::Split::Fit});
  const auto model = loadRobotModel(robots, options.model.empty() ? set.robot : options.model);
  const bool whole = validation::isOnItsFeet(set, *model);
  const auto free = validation::parseFree(options.free, *model, whole);
  if (!options.name.empty()) validation::requireNewRobot(robots, options.name);
  const auto found =
      whole ? validation::optimiseWhole(set, model, free, options.optimise)
            : validation::optimise(validation::prepareSet(set, model, options.optimise.jobs), free,
                                   options.optimise);
  const validation::Report report = reportOptimised(found, model->name);
  std::printf("%s", (options.json ? toJson(report) + "\n" : toText(report)).c_str());
  if (options.name.empty()) return;
  const std::string file = validation::writeExtendedRobot(
      robots, options.name, *model, found.settings, "Fitted to " + set.name + ": " + options.free);
  if (!options.json) std::printf("%s\n", file.c_str());
}

}  // namespace

void addOptimise(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("optimise", "Fits chosen numbers of effects to a recorded set.");
  command->add_option("set", options->set, "Folder of the set (RobotLog 1).")->required();
  command->add_option("--model", options->model, "The robot; default: the set's own.");
  command
      ->add_option("--free", options->free,
                   "effect.parameter[@joint],...: without a joint one number for all of them,\n"
                   "with @each one for every joint.")
      ->required();
  command->add_option("--robot-id", options->robot_id,
                      "Of a set of several robots this one's runs.");
  command->add_option("-o,--output", options->name, "Write a robot of this name.");
  command->add_option("--robots-dir", options->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_option("--runs", options->optimise.runs, "Simulated runs per motion, with repeats.")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--jobs", options->optimise.jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "One JSON object instead of text.");
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
