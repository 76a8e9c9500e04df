#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/diagnosis/extend/next_experiment.h"
#include "validation/diagnosis/report/report_file.h"

namespace nao::app {
namespace {

struct Options {
  std::string dir, model, joint, output, robots_dir = "robots";
  int repeats = 6, jobs = 1;
  bool json = false;
};

const validation::Ambiguity& chosen(const std::vector<validation::Ambiguity>& all,
                                    const std::string& joint) {
  if (joint.empty()) return all.front();
  for (const validation::Ambiguity& one : all) {
    if (one.place == joint) return one;
  }
  throw InputError("--joint " + joint + ": it is not ambiguous in this report");
}

void run(const Options& options) {
  const std::string found = options.dir + "/report.json";
  const auto model = loadRobotModel(findSourceFile(options.robots_dir),
                                    validation::reportedModel(found, options.model));
  const auto all = validation::ambiguitiesOf(found, *model);
  const auto& ambiguous = chosen(all, options.joint);
  const auto experiments =
      validation::planExperiments(model, ambiguous, options.repeats, options.jobs);
  const auto report = reportPlan(ambiguous, experiments, *model, options.repeats);
  std::printf("%s", (options.json ? toJson(report) + "\n" : toText(report)).c_str());
  const std::string file = options.output.empty() ? options.dir + "/next.motion" : options.output;
  validation::writeMotion(experiments.front().motion, *model, file);
  if (!options.json) std::printf("%s\n", file.c_str());
}

}  // namespace

void addPlan(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "plan", "The next experiment that tells apart what a diagnosis could not, as a motion file.");
  command->add_option("dir", options->dir, "What `diagnose --out` wrote.")->required();
  command->add_option("--model", options->model,
                      "The nominal robot; the report's own if not given.");
  command->add_option("--joint", options->joint,
                      "This joint (or limb, or robot); default: the first that is ambiguous.");
  command->add_option("-o,--output", options->output,
                      "The motion file (.motion); default: next.motion in the folder.");
  command->add_option("--repeats", options->repeats, "Runs that the experiment will have.")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--robots-dir", options->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_option("--jobs", options->jobs, "Threads; the result is the same.")
      ->check(CLI::Range(1, 64));
  command->add_flag("--json", options->json, "One JSON object instead of text.");
  command->callback([options] { run(*options); });
}

}  // namespace nao::app
