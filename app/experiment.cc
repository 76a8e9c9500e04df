#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/modes.h"
#include "app/source_paths.h"
#include "validation/experiment.h"

namespace nao::app {
namespace {

using validation::Choice;

struct Arguments {
  validation::Experiment experiment;
  validation::ExperimentSettings settings;
  double step = 0;      // [s]
  double duration = 0;  // [s]
  std::string mode = "implicit";
  bool json = false;
  std::string plot;
};

void run(Arguments& arguments) {
  validation::ExperimentSettings& settings = arguments.settings;
  settings.robots_dir = findSourceFile(settings.robots_dir);
  settings.motions_dir = findSourceFile(settings.motions_dir);
  if (!settings.world.empty()) settings.world = findSourceFile(settings.world);
  settings.step = fromSeconds(arguments.step);
  settings.mode = parseMode(arguments.mode);
  settings.duration = fromSeconds(arguments.duration);
  if (!arguments.plot.empty()) validation::requirePlot(arguments.plot);
  const validation::Outcome outcome = arguments.experiment.run(settings);
  if (arguments.json) {
    std::printf("%s\n", toJson(outcome.report).c_str());
  } else {
    std::printf("%s", toText(outcome.report).c_str());
  }
  if (arguments.plot.empty()) return;
  draw(outcome.picture, arguments.plot);
  std::fprintf(stderr, "wrote %s\n", arguments.plot.c_str());
}

void addChoices(CLI::App& command, const std::shared_ptr<Arguments>& arguments) {
  const validation::Experiment& experiment = arguments->experiment;
  validation::ExperimentSettings& settings = arguments->settings;
  if (experiment.heeds(Choice::Robot)) {
    command.add_option("--robot", settings.robot, "A robot of the folder robots/.")
        ->capture_default_str();
    command.add_option("--robots-dir", settings.robots_dir, "Where the robots' folders are.")
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::World)) {
    command.add_option("--world", settings.world, "A YAML file. Default: a flat ground.");
  }
  if (experiment.heeds(Choice::Step)) {
    command.add_option("--step", arguments->step, "Length of a physics step [s], 0.001 to 0.005.")
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Mode)) {
    command.add_option("--mode", arguments->mode, "How to integrate: implicit, rk4 or reference.")
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Seed)) {
    command.add_option("--seed", settings.seed, "Start of all random numbers; 0: no chance.")
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Runs)) {
    command.add_option("--runs", settings.runs, "How often.")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Duration)) {
    command.add_option("--duration", arguments->duration, "Simulated time of a run [s].")
        ->check(CLI::Range(0.01, 1e6))
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Metres)) {
    command.add_option("--metres", settings.metres, "Also walk straight on for so long [m].")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
  }
  if (experiment.heeds(Choice::Newton)) {
    command
        .add_option("--newton", settings.newton, "Push this hard [N]. Default: find out how hard.")
        ->check(CLI::Range(0.1, 1000.0));
  }
}

}  // namespace

void addExperiment(CLI::App& app) {
  CLI::App* group = app.add_subcommand(
      "experiment", "Repeats an experiment of the thesis and shows its figures beside ours.");
  group->require_subcommand(1);
  for (const validation::Experiment& experiment : validation::experiments()) {
    auto arguments = std::make_shared<Arguments>();
    arguments->experiment = experiment;
    arguments->settings = experiment.defaults;
    arguments->step = toSeconds(experiment.defaults.step);
    arguments->duration = toSeconds(experiment.defaults.duration);
    CLI::App* command = group->add_subcommand(experiment.name, experiment.summary);
    addChoices(*command, arguments);
    command->add_flag("--json", arguments->json, "One JSON object instead of tables.");
    command->add_option("--plot", arguments->plot, "Also draws a picture: FILE.svg or FILE.png.");
    command->callback([arguments] { run(*arguments); });
  }
}

}  // namespace nao::app
