// Microseconds of processor time per 2 ms step of one Nao, beside MuJoCo's on the same robot in
// the same run. `scripts/bench` prints the ratios.
#include <benchmark/benchmark.h>

#include "bench/mujoco_nao.h"
#include "runtime/simulation.h"
#include "sim/world.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;

constexpr Duration kStep = 2ms;
constexpr int kSteps = 500;  // one simulated second per iteration

std::shared_ptr<const RobotModel> model() {
  return loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
}

void report(benchmark::State& state) {
  const double steps = static_cast<double>(state.iterations()) * kSteps;
  state.counters["step_us"] =
      benchmark::Counter(steps * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["realtime_factor"] =
      benchmark::Counter(steps * toSeconds(kStep), benchmark::Counter::kIsRate);
}

void standing(benchmark::State& state) {
  const auto robot = model();
  sim::World world(std::make_shared<WorldModel>(), {{"nao", robot, {}}}, kStep);
  const JointCommand command{robot->findPosture("StandInit")->angle,
                             JointArray<double>(robot->jointCount(), 1.0)};
  world.placeRobot(0, {}, &command.angle);
  for (auto _ : state) {
    for (int k = 0; k < kSteps; ++k) {
      if (k % 5 == 0) world.setCommand(0, command);
      world.step();
    }
  }
  report(state);
}

// With motion engine, walk engine and sensors, as the daemon runs it.
void walking(benchmark::State& state) {
  runtime::Simulation simulation(std::make_shared<WorldModel>(), {{"nao", model(), {}}}, kStep);
  auto& requests = simulation.robot(0).ports()->requests;
  NAO_CHECK(requests.post({1, motion::WakeUp{}}));
  simulation.advanceTo(simulation.now() + 4000ms);
  NAO_CHECK(requests.post({2, motion::MoveToward{1, 0, 0, {}}}));
  simulation.advanceTo(simulation.now() + 2000ms);
  for (auto _ : state) simulation.advanceTo(simulation.now() + kSteps * kStep);
  if (!simulation.robot(0).ports()->state.get()->move_active) state.SkipWithError("it fell");
  report(state);
}

void mujocoStanding(benchmark::State& state) {
  const auto robot = model();
  bench::MujocoNao nao(*robot, toSeconds(kStep));
  nao.stand(robot->findPosture("StandInit")->angle);
  for (auto _ : state) {
    for (int k = 0; k < kSteps; ++k) nao.step();
  }
  if (!nao.stands()) state.SkipWithError("MuJoCo's Nao fell: not the same job");
  report(state);
}

BENCHMARK(standing)->Unit(benchmark::kMillisecond);
BENCHMARK(mujocoStanding)->Unit(benchmark::kMillisecond);
BENCHMARK(walking)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nao

BENCHMARK_MAIN();
