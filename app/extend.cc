#include "validation/diagnosis/extend/extension.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/diagnosis/extend/empirical.h"
#include "validation/diagnosis/folds/diagnose_folds.h"
#include "validation/diagnosis/report/report_file.h"
#include "validation/log/log_robots.h"
#include "validation/merge_effects.h"

namespace nao::app {
namespace {

struct Options {
  std::string report, model, robots_dir = "robots", name;
  std::string set;
  validation::Accepted accepted;
  bool empirical = false, causes_only = false;
  int jobs = 1;
};

// The torque that an unknown's signature stands for; none if it is none.
std::optional<EffectSetting> torqueOf(const validation::UnknownJoint& unknown,
                                      const RobotModel& model, const validation::PreparedSet& set) {
  const char* name = unknown.joint.c_str();
  const auto place = model.findJoint(unknown.joint);
  if (!place) {
    std::printf("%s: left out, as it is no joint\n", name);
    return std::nullopt;
  }
  const validation::PreparedJoint& joint = validation::jointOf(set, unknown.joint);
  const auto features =
      unknown.features.empty() ? validation::remainingFeatures(joint) : unknown.features;
  if (features.empty()) {
    std::printf("%s: left out, as %s\n", name,
                validation::isWithoutRepeats(*joint.simulator)
                    ? "without repeats nothing tells what remains from noise"
                    : "nothing that remains goes with its motion");
    return std::nullopt;
  }
  auto fit = validation::fitEmpirical(joint, features);
  fit.setting.joints = {*place};
  std::printf("%s: a torque without a name, error on fit motions %.2f -> %.2f mrad\n", name,
              1e3 * fit.before, 1e3 * fit.after);
  for (const std::string& feature : fit.left_out) std::printf("  left out: %s\n", feature.c_str());
  return std::move(fit.setting);
}

// What has no name: the signatures of the report as torques, fitted to the set beside `causes`.
std::vector<EffectSetting> empiricalEffects(const Options& options, const std::string& report,
                                            const RobotModel& model,
                                            const std::vector<EffectSetting>& causes) {
  if (options.set.empty()) throw InputError("--empirical: expected --set, the diagnosed set");
  const std::string& robot = options.accepted.robot_id;
  const auto unknowns = validation::unknownJoints(report, robot);
  const validation::LogSet set = validation::runsOfOne(validation::readLogSet(options.set), robot);
  auto extended = std::make_shared<RobotModel>(model);
  extended->effects = validation::mergedEffects(model, causes, sim::standardEffects());
  const validation::PreparedSet prepared =
      validation::prepareSet(set, std::move(extended), options.jobs);
  std::vector<EffectSetting> found;
  for (const validation::UnknownJoint& unknown : unknowns) {
    if (auto torque = torqueOf(unknown, model, prepared)) found.push_back(std::move(*torque));
  }
  if (found.empty()) {
    throw InputError("--empirical: no joint's remainder is a torque by its motion");
  }
  return found;
}

void run(const Options& options) {
  const std::string robots = findSourceFile(options.robots_dir);
  const std::string report = options.report + "/report.json";
  const auto model = loadRobotModel(robots, validation::reportedModel(report, options.model));
  if (!options.set.empty() && !options.empirical) {
    throw InputError("--set " + options.set + ": expected --empirical beside it");
  }
  validation::requireNewRobot(robots, options.name);
  std::vector<EffectSetting> causes;
  if (!options.empirical || !options.accepted.causes.empty()) {
    causes = validation::acceptedEffects(report, options.accepted, *model);
  }
  if (options.empirical) {
    for (EffectSetting& one : empiricalEffects(options, report, *model, causes)) {
      causes.push_back(std::move(one));
    }
  }
  const std::size_t accepted = causes.size();
  if (!options.causes_only) {
    for (EffectSetting& one : validation::reportedAdjustments(report, options.accepted, *model)) {
      causes.push_back(std::move(one));
    }
  }
  const std::string file = validation::writeExtendedRobot(
      robots, options.name, *model, causes, "Accepted from the diagnosis in " + options.report);
  std::printf("%s: %s with %zu more effect%s", file.c_str(), model->name.c_str(), accepted,
              accepted == 1 ? "" : "s");
  std::printf(" and %zu small adjustments\n", causes.size() - accepted);
}

}  // namespace

void addExtend(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "extend", "Makes a robot of the nominal one and the causes that a diagnosis found.");
  command->add_option("dir", options->report, "What `diagnose --out` wrote.")->required();
  command->add_option("--accept", options->accepted.causes,
                      "Causes to accept, rivals too. Default: all that are named alone.");
  command->add_option("--robot-id", options->accepted.robot_id,
                      "Of a set of several robots the one that is extended.");
  command->add_flag("--empirical", options->empirical,
                    "Also what has no name: the signature of the unknown, as a torque.");
  command->add_flag("--causes-only", options->causes_only,
                    "Without the small adjustments that the report lists beside the causes.");
  command->add_option("--set", options->set, "The diagnosed set, for --empirical.");
  command->add_option("--jobs", options->jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_option("--model", options->model,
                      "The nominal robot; the report's own if not given.");
  command->add_option("-o,--output", options->name, "Name of the new robot.")->required();
  command->add_option("--robots-dir", options->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
