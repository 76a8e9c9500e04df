#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "core/robot_model.h"
#include "validation/describe_robot.h"

namespace nao::app {
namespace {

struct Arguments {
  std::string robot;
  std::string robots_dir = "robots";
  bool json = false;
};

void describe(const Arguments& arguments) {
  const auto model = loadRobotModel(findSourceFile(arguments.robots_dir), arguments.robot);
  const validation::Report report = validation::describeRobot(*model);
  std::printf("%s\n", (arguments.json ? toJson(report) : toText(report)).c_str());
}

}  // namespace

void addDescribe(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "describe", "Tells what a robot's files say: masses, motors, limits, sensors, effects.");
  command->add_option("robot", arguments->robot, "A robot of the folder robots/, or FILE.urdf.")
      ->required();
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "One JSON object instead of tables.");
  command->callback([arguments] { describe(*arguments); });
}

}  // namespace nao::app
