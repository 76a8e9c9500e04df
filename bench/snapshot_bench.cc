// Microseconds of processor time to take a snapshot of a walking Nao with its motion engine and to
// go back to one, and whether memory stays: `snapshot_cpu_us`, `restore_cpu_us`, and
// `restore_growth_kb`, what the resident memory grew by over all measured restores.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <fstream>

#include "runtime/simulation.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;

std::unique_ptr<runtime::Simulation> walking() {
  const auto model = loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
  auto simulation = std::make_unique<runtime::Simulation>(
      std::make_shared<WorldModel>(), std::vector<sim::RobotSetup>{{"nao", model, {}}}, 2ms);
  auto& requests = simulation->robot(0).ports()->requests;
  NAO_CHECK(requests.post({1, motion::WakeUp{}}));
  simulation->advanceTo(simulation->now() + 4000ms);
  NAO_CHECK(requests.post({2, motion::MoveToward{1, 0, 0, {}}}));
  simulation->advanceTo(simulation->now() + 2000ms);
  return simulation;
}

double residentKb() {
  std::ifstream statm("/proc/self/statm");
  double total = 0;
  double resident = 0;
  statm >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1024;
}

void report(benchmark::State& state, const char* name) {
  state.counters[name] =
      benchmark::Counter(static_cast<double>(state.iterations()) * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void takeSnapshot(benchmark::State& state) {
  const auto simulation = walking();
  for (auto _ : state) benchmark::DoNotOptimize(simulation->snapshot());
  report(state, "snapshot_cpu_us");
}

void restore(benchmark::State& state) {
  const auto simulation = walking();
  const auto snapshot = simulation->snapshot();
  for (int k = 0; k < 1000; ++k) simulation->restore(*snapshot);
  const double before = residentKb();
  for (auto _ : state) simulation->restore(*snapshot);
  report(state, "restore_cpu_us");
  state.counters["restore_growth_kb"] = residentKb() - before;
}

BENCHMARK(takeSnapshot)->Unit(benchmark::kMicrosecond);
BENCHMARK(restore)->Unit(benchmark::kMicrosecond)->Iterations(100000);

}  // namespace
}  // namespace nao

BENCHMARK_MAIN();
