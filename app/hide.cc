#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/hand_over.h"

namespace nao::app {

void addHide(CLI::App& app) {
  CLI::App* hide = app.add_subcommand(
      "hide",
      "Records a set from a simulated robot in which something is wrong, for trying `diagnose`.\n"
      "What it is stands in a file apart. Options are those of usarnaoqi-hide: --effects, --n,\n"
      "--seed, --joints, --size or --value, --scene, --level, --repeats, -o SET; `hide --help` "
      "tells "
      "them.");
  hide->prefix_command();
  hide->callback([hide] { handOver("usarnaoqi-hide", hide->remaining(), "hide"); });
}

}  // namespace nao::app
