#include "validation/diagnosis/extend/gain.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/log/log_robots.h"

namespace nao::app {
namespace {

struct Options {
  std::string set, before, after, robot_id, robots_dir = "robots";
  validation::GainOptions gain;
  bool json = false;
};

void run(const Options& options) {
  const std::string robots = findSourceFile(options.robots_dir);
  const validation::LogSet set =
      validation::runsOfOne(validation::readLogSet(options.set), options.robot_id);
  const std::string name = options.before.empty() ? set.robot : options.before;
  const auto before = loadRobotModel(robots, name);
  const auto after = loadRobotModel(robots, options.after);
  validation::requireOpenable(set, options.set);
  const int openings = validation::countTestOpenings(options.set) + 1;
  const validation::Report report =
      validation::measureGain(set, before, after, openings, options.gain);
  validation::openTestRuns(set, options.set, "gain: " + name + " -> " + options.after);
  std::printf("%s", (options.json ? toJson(report) + "\n" : toText(report)).c_str());
}

}  // namespace

void addGain(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "gain", "How much nearer an extended robot comes to the test runs of a recorded set.");
  command->add_option("set", options->set, "Folder of the set (RobotLog 1).")->required();
  command->add_option("--before", options->before, "The nominal robot; default: the set's own.");
  command->add_option("--after", options->after, "The extended robot.")->required();
  command->add_option("--robot-id", options->robot_id,
                      "Of a set of several robots this one's runs.");
  command->add_option("--robots-dir", options->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_option("--runs", options->gain.runs, "Simulated runs per motion.")
      ->check(CLI::Range(2, 1000))
      ->capture_default_str();
  command->add_option("--jobs", options->gain.jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "One JSON object instead of text.");
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
