#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/replay_run.h"
#include "app/source_paths.h"
#include "validation/diagnosis/extend/replay_set.h"
#include "validation/log/error_map.h"
#include "validation/log/log_robots.h"

namespace nao::app {
namespace {

struct Options {
  std::string what, model, robot_id;
  ReplayRunOptions run;
  validation::ReplayOptions replay;
  bool json = false;
};

constexpr int kDiffers = 20;  // exit code

void replaySet(const Options& options) {
  const validation::LogSet set =
      validation::runsOfOne(validation::readLogSet(options.what), options.robot_id);
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

void run(Options& options) {
  if (std::filesystem::is_directory(options.what)) return replaySet(options);
  options.run.file = options.what;
  if (!replayRun(options.run)) throw CLI::RuntimeError(kDiffers);
}

void addRunOptions(CLI::App& command, ReplayRunOptions& options) {
  const char* const group = "Of a recorded run";
  command
      .add_option("--from", options.from, "What is compared, listed and written begins here [s].")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
  command.add_option("--to", options.to, "The replay ends here [s].")
      ->check(CLI::NonNegativeNumber)
      ->group(group);
  command
      .add_option("--set", options.set,
                  "Changes what the run began with, and says where it then parts from itself:\n"
                  "ROBOT.effects.EFFECT.PARAMETER=NUMBER, ROBOT.effects.EFFECT=off,\n"
                  "world.friction=NUMBER, seed=NUMBER. ROBOT: a name, or `robot` for all.")
      ->group(group);
  command
      .add_option("--diff", options.diff,
                  "Another recording: where the two first differ, in what, by how much.")
      ->group(group);
  command.add_option("--csv", options.csv, "Writes commands, sensors and the true place there.")
      ->group(group);
  command.add_option("--set-out", options.set_out, "Writes the same as a set (RobotLog 1).")
      ->group(group);
  command.add_option("--signals-of", options.robot, "Of this robot. Default: the first.")
      ->group(group);
  command.add_flag("--inputs", options.inputs, "Lists what came in.")->group(group);
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "replay",
      "Does a recorded run (serve --record) again to the last bit, and says if it parts.\n"
      "Or, of a folder: replays the commands of a recorded set on a model: what the simulation\n"
      "gets wrong. Of a robot without a model: how its joints follow, and left against right.");
  const auto options = std::make_shared<Options>();
  command->add_option("what", options->what, "A recorded run, or the folder of a set (RobotLog 1).")
      ->required();
  command->add_option("--model", options->model, "A robot of robots/; default: the set's own.");
  command->add_option("--robot-id", options->robot_id,
                      "Of a set of several robots this one's runs.");
  command->add_option("--runs", options->replay.runs, "Simulated runs per motion.")
      ->check(CLI::Range(2, 1000));
  command->add_option("--jobs", options->replay.jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "One JSON object instead of text.");
  addRunOptions(*command, options->run);
  command->footer("The exit code is 20 if a run parts from what was recorded, or from the other.");
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
