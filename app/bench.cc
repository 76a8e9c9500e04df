#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/hand_over.h"

namespace nao::app {

void addBench(CLI::App& app) {
  CLI::App* bench = app.add_subcommand("bench", "Puts a part of the program on trial.");
  bench->require_subcommand(1);
  CLI::App* diagnosis = bench->add_subcommand(
      "diagnosis",
      "Hides effects in simulated sets and counts what `diagnose` finds. Options are those of\n"
      "usarnaoqi-bench-diagnosis: --preset quick, standard or full, --seed, --shard i/n, --out "
      "...");
  diagnosis->prefix_command();
  diagnosis->callback([diagnosis] {
    handOver("usarnaoqi-bench-diagnosis", diagnosis->remaining(), "bench diagnosis");
  });
}

}  // namespace nao::app
