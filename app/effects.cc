#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "validation/effect_list.h"

namespace nao::app {

void addEffects(CLI::App& app) {
  CLI::App* command = app.add_subcommand(
      "effects",
      "Lists what can make a robot worse than its drawing, for `effects:` in body.yaml.");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One JSON object instead of text.");
  command->callback([json] {
    const std::string list =
        *json ? validation::listEffectsAsJson() + "\n" : validation::listEffectsAsText();
    std::fputs(list.c_str(), stdout);
  });
}

}  // namespace nao::app
