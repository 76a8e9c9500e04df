#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "validation/diagnosis/cause_list.h"

namespace nao::app {

void addCatalog(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "catalog", "Lists the causes that `diagnose` tries; `catalog show ID` explains one.");
  const auto id = std::make_shared<std::string>();
  CLI::App* show = command->add_subcommand("show", "Explains one cause.");
  show->add_option("id", *id, "As listed.")->required();
  show->callback([id] { std::printf("%s", validation::showCause(*id).c_str()); });
  command->callback([show] {
    if (!show->parsed()) std::printf("%s", validation::listCausesAsText().c_str());
  });
}

}  // namespace nao::app
