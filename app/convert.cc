#include "validation/log/convert.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>

#include "app/commands.h"
#include "app/source_paths.h"
#include "core/check.h"
#include "validation/log/growing_set.h"

namespace nao::app {
namespace {

using validation::LogFormat;
using validation::Split;

struct Arguments {
  std::string from;
  std::string to;
  std::string format;
  std::string split;
  std::string robots_dir = "robots";
  validation::ConvertSettings settings;
};

const std::map<std::string, LogFormat>& formats() {
  static const std::map<std::string, LogFormat> kFormats{{"bam", LogFormat::Bam},
                                                         {"poppy", LogFormat::Poppy},
                                                         {"almemory", LogFormat::Almemory},
                                                         {"lola", LogFormat::Lola}};
  return kFormats;
}

// Of a robot that is not ours, such as Poppy, every joint stays.
void leaveOutUnknownJoints(const Arguments& arguments, validation::LogSet& set) {
  const std::string folder = findSourceFile(arguments.robots_dir);
  if (!std::filesystem::is_directory(folder + "/" + set.robot)) return;
  const auto model = loadRobotModel(folder, set.robot);
  std::string names;
  for (const std::string& name : validation::leaveOutUnknownJoints(set, *model)) {
    names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) {
    std::fprintf(stderr, "left out, as %s has no such joints: %s\n", set.robot.c_str(),
                 names.c_str());
  }
  if (set.joints.empty()) {
    throw InputError(arguments.from + ": expected joints of " + set.robot + ", found none");
  }
}

void run(Arguments& arguments) {
  const LogFormat format = arguments.format.empty() ? validation::guessFormat(arguments.from)
                                                    : formats().at(arguments.format);
  for (const Split split : {Split::Fit, Split::Select, Split::Test}) {
    if (arguments.split == validation::nameOf(split)) arguments.settings.split = split;
  }
  validation::requireNoSet(arguments.to);
  auto set = validation::convertLog(arguments.from, format, arguments.settings);
  leaveOutUnknownJoints(arguments, set);
  validation::writeLogSet(set, arguments.to);
  std::printf("%zu runs of %zu joints, %.1f rows a second: %s\n", set.runs.size(),
              set.joints.size(), set.rate, arguments.to.c_str());
}

}  // namespace

void addConvert(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("convert", "Turns recordings of others into a set (docs/robot_log.md).");
  command->add_option("from", arguments->from, "A file, or a folder of files.")->required();
  command->add_option("to", arguments->to, "The set's folder; made if it is not there.")
      ->required();
  command->add_option("--format", arguments->format, "Default: what the contents look like.")
      ->check(CLI::IsMember(formats()));
  command->add_option("--split", arguments->split, "What all runs are for. Default: see docs.")
      ->check(CLI::IsMember({"fit", "select", "test"}));
  command->add_option("--robot", arguments->settings.robot,
                      "The nominal model, a robot of the folder robots/.");
  command->add_option("--motion", arguments->settings.motion,
                      "All runs are repeats of this motion. Default: each is one of its own.");
  command->add_flag("--suspended", arguments->settings.suspended,
                    "The robot hung by its torso, feet in the air.");
  command->add_option("--robots-dir", arguments->robots_dir, "Where the robots' folders are.")
      ->capture_default_str();
  command->add_option("--licence", arguments->settings.licence, "Of the data, kept in the set.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
