// Microseconds of processor time to take a snapshot of a walking Nao with its motion engine and to
// go back to one: `snapshot_cpu_us`, `restore_cpu_us`. Whether both stay as they are over 100,000
// restores: `restore_last_over_first`, the cost of the last tenth of them over that of the first,
// and `restore_growth_kb`, what the resident memory grew by.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <array>
#include <ctime>
#include <fstream>

#include "runtime/simulation.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;

constexpr int kRestores = 100'000;

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
  constexpr int kTenth = kRestores / 10;
  std::array<std::clock_t, 11> at{};  // processor time after each tenth
  int done = 0;
  for (auto _ : state) {
    if (done % kTenth == 0) at[done / kTenth] = std::clock();
    simulation->restore(*snapshot);
    ++done;
  }
  at.back() = std::clock();
  report(state, "restore_cpu_us");
  state.counters["restore_last_over_first"] =
      static_cast<double>(at[10] - at[9]) / static_cast<double>(at[1] - at[0]);
  state.counters["restore_growth_kb"] = residentKb() - before;
}

BENCHMARK(takeSnapshot)->Unit(benchmark::kMicrosecond);
BENCHMARK(restore)->Unit(benchmark::kMicrosecond)->Iterations(kRestores);

}  // namespace
}  // namespace nao

BENCHMARK_MAIN();
