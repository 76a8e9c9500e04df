#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "validation/diagnosis/causes/cause_list.h"

namespace nao::app {
namespace {

struct Arguments {
  std::string id;
  std::string level = "joint";
  std::string robot = "nao_h21_v33";
  std::string robots_dir = "robots";
  bool json = false;
};

std::shared_ptr<const RobotModel> load(const Arguments& arguments) {
  return loadRobotModel(findSourceFile(arguments.robots_dir), arguments.robot);
}

void list(const Arguments& arguments) {
  const auto causes = validation::listCauses(arguments.level, *load(arguments));
  std::printf("%s",
              (arguments.json ? validation::toJson(causes) : validation::toText(causes)).c_str());
}

}  // namespace

void addCatalog(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "catalog", "Lists the causes that `diagnose` tries; `catalog show ID` explains one.");
  const auto arguments = std::make_shared<Arguments>();
  command->add_option("--level", arguments->level, "joint, limb or robot.")
      ->check(CLI::IsMember({"joint", "limb", "robot"}))
      ->capture_default_str();
  command->add_option("--robot", arguments->robot, "Whose joints and limbs.")
      ->capture_default_str();
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "A JSON array instead of text.");
  CLI::App* show = command->add_subcommand("show", "Explains one cause.");
  show->add_option("id", arguments->id, "As listed.")->required();
  show->callback([arguments] {
    std::printf("%s", validation::showCause(arguments->id, *load(*arguments)).c_str());
  });
  command->callback([arguments, show] {
    if (!show->parsed()) list(*arguments);
  });
}

}  // namespace nao::app
