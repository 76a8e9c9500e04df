// Processor time per 2 ms step of one Nao, beside MuJoCo's on the same robot with the same commands
// in the same run, and of many. `scripts/bench` prints the ratios.
#include <benchmark/benchmark.h>

#include "bench/mujoco_nao.h"
#include "runtime/simulation.h"
#include "sim/world.h"
#include "validation/walk_recording.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;
using validation::WalkRecording;
using validation::WalkReplay;

constexpr Duration kStep = 2ms;
constexpr int kStepsPerCycle = 5;
constexpr int kCycles = 400;  // standing, per iteration

std::shared_ptr<const RobotModel> model(const char* name = "nao_h21_v33") {
  return loadRobotModel(NAO_SOURCE_DIR "/robots", name);
}

// Recorded once, so that all replay the same.
const WalkRecording& walk() {
  static const WalkRecording recording = validation::recordWalk(model(), 6000ms);
  return recording;
}

// `robots`: whose steps count, all of them.
void report(benchmark::State& state, std::size_t cycles, int robots = 1) {
  const double steps =
      static_cast<double>(state.iterations()) * static_cast<double>(cycles) * kStepsPerCycle;
  state.counters["step_us"] = benchmark::Counter(
      steps * robots * 1e-6, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["realtime_factor"] =
      benchmark::Counter(steps * toSeconds(kStep), benchmark::Counter::kIsRate);
}

// With sensors, as the daemon reads them: once per cycle.
void standing(benchmark::State& state, const char* name) {
  const auto robot = model(name);
  sim::World world(std::make_shared<WorldModel>(), {{"nao", robot, {}}}, kStep);
  const JointCommand command{robot->findPosture("StandInit")->angle,
                             JointArray<double>(robot->jointCount(), 1.0)};
  world.placeRobot(0, {}, &command.angle);
  for (auto _ : state) {
    for (int k = 0; k < kCycles * kStepsPerCycle; ++k) {
      if (k % kStepsPerCycle == 0) {
        benchmark::DoNotOptimize(world.readSensors(0));
        world.setCommand(0, command);
      }
      world.step();
    }
  }
  if (!validation::allStand(world)) state.SkipWithError("it fell");
  report(state, kCycles);
}

void replay(benchmark::State& state, sim::World& world, int robots) {
  WalkReplay replay(walk());
  for (auto _ : state) {
    replay.restart(world);
    while (!replay.done()) replay.advance(world);
    if (!validation::allStand(world)) state.SkipWithError("it fell");
  }
  state.counters["distance_m"] = world.scene().robots[0].X_WB[0].translation().x();
  report(state, walk().commands.size(), robots);
}

void walking(benchmark::State& state, const char* name) {
  sim::World world(std::make_shared<WorldModel>(), {{"nao", model(name), {}}}, kStep);
  replay(state, world, 1);
}

void walkingRobots(benchmark::State& state) {
  const auto robots = static_cast<int>(state.range(0));
  auto field = std::make_shared<WorldModel>();
  field->balls.push_back({});
  field->balls.back().p_W = Vec3(2, 2.5, 0.0325);
  sim::World world(field, validation::robotsInRows(model(), robots), kStep);
  replay(state, world, robots);
}

// With motion engine, walk engine and sensors, as the daemon runs them.
void walkingWithMotion(benchmark::State& state) {
  const auto robots = static_cast<int>(state.range(0));
  const auto nao = model();
  runtime::Simulation simulation(std::make_shared<WorldModel>(),
                                 validation::robotsInRows(nao, robots), kStep);
  for (std::size_t i = 0; i < simulation.robotCount(); ++i) {
    auto& requests = simulation.robot(i).ports()->requests;
    NAO_CHECK(requests.post({1, motion::WakeUp{}}));
    NAO_CHECK(requests.post({2, motion::MoveToward{1, 0, 0, {}}}));
  }
  simulation.advanceTo(simulation.now() + 5000ms);
  for (auto _ : state) {
    simulation.advanceTo(simulation.now() + kCycles * kStepsPerCycle * kStep);
  }
  if (!validation::allStand(simulation.world())) state.SkipWithError("it fell");
  report(state, kCycles, robots);
}

void mujocoStanding(benchmark::State& state) {
  const auto robot = model();
  bench::MujocoNao nao(*robot, toSeconds(kStep));
  nao.stand(robot->findPosture("StandInit")->angle);
  for (auto _ : state) {
    for (int k = 0; k < kCycles * kStepsPerCycle; ++k) nao.step();
  }
  if (!nao.stands()) state.SkipWithError("MuJoCo's Nao fell: not the same job");
  report(state, kCycles);
}

void mujocoWalking(benchmark::State& state) {
  const auto robot = model();
  bench::MujocoNao nao(*robot, toSeconds(kStep));
  nao.stand(walk().start);
  const bench::MujocoNao::State start = nao.state();
  double distance = 0;
  for (auto _ : state) {
    nao.setState(start);
    for (const JointCommand& command : walk().commands) {
      nao.command(command.angle);
      for (int k = 0; k < kStepsPerCycle; ++k) nao.step();
    }
    if (!nao.stands()) state.SkipWithError("MuJoCo's Nao fell: not the same job");
    distance = nao.position().x();
  }
  state.counters["distance_m"] = distance;
  report(state, walk().commands.size());
}

BENCHMARK_CAPTURE(standing, effects, "nao_h21_v33")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(standing, ideal, "nao_h21_v33_ideal")->Unit(benchmark::kMillisecond);
BENCHMARK(mujocoStanding)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walking, effects, "nao_h21_v33")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(walking, ideal, "nao_h21_v33_ideal")->Unit(benchmark::kMillisecond);
BENCHMARK(mujocoWalking)->Unit(benchmark::kMillisecond);
BENCHMARK(walkingRobots)
    ->ArgName("robots")
    ->Arg(1)
    ->Arg(2)
    ->Arg(4)
    ->Arg(8)
    ->Arg(22)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(walkingWithMotion)->ArgName("robots")->Arg(1)->Arg(22)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nao

BENCHMARK_MAIN();
