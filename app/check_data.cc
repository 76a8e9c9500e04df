#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/log/data_faults.h"

namespace nao::app {
namespace {

constexpr int kDataFault = 20;  // exit code

struct Arguments {
  std::string set;
  std::string robots_dir = "robots";
  bool json = false;
};

// The set's robot, if it is one of ours: data of others can be checked too.
std::shared_ptr<const RobotModel> findModel(const Arguments& arguments, const std::string& robot) {
  const std::string folder = findSourceFile(arguments.robots_dir);
  if (robot.empty() || !std::filesystem::is_directory(folder + "/" + robot)) return nullptr;
  return loadRobotModel(folder, robot);
}

void run(const Arguments& arguments) {
  const validation::LogSet set = validation::readLogSet(arguments.set);
  const auto model = findModel(arguments, set.robot);
  const auto findings = validation::findDataFaults(set, model.get());
  const validation::Report report = validation::reportDataFaults(set, findings);
  std::printf("%s", (arguments.json ? toJson(report) + "\n" : toText(report)).c_str());
  if (validation::anyFault(findings)) throw CLI::RuntimeError(kDataFault);
}

}  // namespace

void addCheckData(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "check-data",
      "Looks for faults in a recorded set (docs/robot_log.md): clocks, gaps, repeated samples,\n"
      "swapped or negated joints, units. Exit code 20 if there is one.");
  command->add_option("set", arguments->set, "The set's folder.")->required();
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "One JSON object instead of text.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
