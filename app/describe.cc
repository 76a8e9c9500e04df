#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "core/check.h"
#include "core/robot_model.h"
#include "naoqi_api/reference.h"
#include "naoqi_api/services/robot_services.h"
#include "validation/describe_robot.h"

namespace nao::app {
namespace {

struct Arguments {
  std::string robot;
  std::string robots_dir = "robots";
  std::string service;
  bool services = false;
  bool markdown = false;
  bool json = false;
};

// What clients find on a robot, made without one that moves.
void describeServices(const Arguments& arguments) {
  const std::string robot = arguments.robot.empty() ? "nao_h25_v50" : arguments.robot;
  services::RobotServicesSetup setup;
  setup.ports = std::make_shared<motion::RobotPorts>();
  setup.images = std::make_shared<camera::ImageFeed>();
  services::RobotLink link(loadRobotModel(findSourceFile(arguments.robots_dir), robot),
                           setup.ports);
  services::RobotServices services(link, setup);
  rpc::ServiceHub hub({});
  services.addTo(hub);
  const rpc::ServiceHub::Entry* only = hub.find(std::string_view(arguments.service));
  if (!arguments.service.empty() && !only) {
    throw InputError("--service: there is no service '" + arguments.service +
                     "'; `usarnaoqi describe --services` lists them");
  }
  const std::string text = arguments.json       ? referenceJson(hub, arguments.service) + "\n"
                           : !only              ? coveragePage(hub)
                           : arguments.markdown ? referenceMarkdown(*only->service)
                                                : referenceText(*only->service);
  std::fputs(text.c_str(), stdout);
}

void describe(const Arguments& arguments) {
  if (arguments.services || !arguments.service.empty()) return describeServices(arguments);
  if (arguments.robot.empty()) {
    throw InputError("describe: expected a robot, --services or --service NAME");
  }
  const auto model = loadRobotModel(findSourceFile(arguments.robots_dir), arguments.robot);
  const validation::Report report = validation::describeRobot(*model);
  std::printf("%s\n", (arguments.json ? toJson(report) : toText(report)).c_str());
}

}  // namespace

void addDescribe(CLI::App& app) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "describe",
      "Tells what a robot's files say: masses, motors, limits, sensors, effects; or, with\n"
      "--services or --service, what clients can call.");
  command->add_option("robot", arguments->robot, "A robot of the folder robots/, or FILE.urdf.");
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_flag("--services", arguments->services, "How much of each service is simulated.");
  command->add_option("--service", arguments->service, "The methods of one service.");
  command->add_flag("--markdown", arguments->markdown, "Markdown instead of plain text.");
  command->add_flag("--json", arguments->json, "One JSON object instead of tables.");
  command->callback([arguments] { describe(*arguments); });
}

}  // namespace nao::app
