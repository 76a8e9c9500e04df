#include "validation/log/convert.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <memory>

#include "app/commands.h"

namespace nao::app {
namespace {

using validation::LogFormat;
using validation::Split;

struct Arguments {
  std::string from;
  std::string to;
  std::string format;
  std::string split;
  validation::ConvertSettings settings;
};

const std::map<std::string, LogFormat>& formats() {
  static const std::map<std::string, LogFormat> kFormats{{"bam", LogFormat::Bam},
                                                         {"poppy", LogFormat::Poppy},
                                                         {"almemory", LogFormat::Almemory},
                                                         {"lola", LogFormat::Lola}};
  return kFormats;
}

void run(Arguments& arguments) {
  const LogFormat format = arguments.format.empty() ? validation::guessFormat(arguments.from)
                                                    : formats().at(arguments.format);
  for (const Split split : {Split::Fit, Split::Select, Split::Test}) {
    if (arguments.split == validation::nameOf(split)) arguments.settings.split = split;
  }
  const auto set = validation::convertLog(arguments.from, format, arguments.settings);
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
  command->add_option("--licence", arguments->settings.licence, "Of the data, kept in the set.");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace nao::app
