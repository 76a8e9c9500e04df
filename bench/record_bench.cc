// What recording a run costs: the same minute without and with a Recorder, in turns of 100 ms of
// simulated time, `cost_percent` of processor time; and `mb_per_minute` of the file, without the
// world and robots that it begins with. A Nao that walks, lit anew by ALLeds' fades all the time;
// and one whose body a LoLA client commands, all joints in every cycle.
#include <benchmark/benchmark.h>
#include <stdlib.h>

#include <cmath>
#include <ctime>
#include <filesystem>

#include "runtime/recorder.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using runtime::Simulation;

runtime::RunStart start(const char* robot) {
  runtime::RunStart start;
  start.world = std::make_shared<WorldModel>();
  start.robots = {{"nao", loadRobotModel(NAO_SOURCE_DIR "/robots", robot), {}}};
  return start;
}

using Client = void (*)(Simulation& simulation, int turn);

// Before a turn of 20 ms: a fade's next shade for both eyes; a new direction each second.
void walk(Simulation& simulation, int turn) {
  motion::RobotPorts& ports = *simulation.robot(0).ports();
  const auto id = static_cast<motion::RequestId>(turn + 1);
  if (turn == 0) NAO_CHECK(ports.requests.post({id, motion::WakeUp{}}));
  if (turn >= 200 && turn % 50 == 0) {
    NAO_CHECK(ports.requests.post({id, motion::MoveToward{0.7, 0, 0.4 * std::sin(turn), {}}}));
  }
  const auto leds = ledNames(simulation.robot(0).model());
  for (std::size_t i = 0; i < 16; ++i) {
    const auto shade = static_cast<float>(turn % 100) * 0.01f;
    NAO_CHECK(ports.leds.post({leds[i], shade}));
  }
}

void drive(Simulation& simulation, int turn) {
  const std::size_t joints = simulation.robot(0).model().jointCount();
  BodyCommand command{static_cast<std::uint64_t>(turn + 1), JointArray<double>(joints),
                      JointArray<double>(joints, 0.5)};
  for (std::size_t j = 0; j < joints; ++j) {
    command.angle[j] = static_cast<float>(0.1 * std::sin(0.1 * turn + static_cast<double>(j)));
  }
  simulation.robot(0).ports()->body.publish(command);
}

/// Processor time of a stretch of turns.
double advance(Simulation& simulation, Client client, Duration length, int first, int turns) {
  const std::clock_t begin = std::clock();
  for (int turn = first; turn < first + turns; ++turn) {
    client(simulation, turn);
    simulation.advanceTo(simulation.now() + length);
  }
  return static_cast<double>(std::clock() - begin);
}

class TemporaryFile {
 public:
  TemporaryFile() {
    std::string pattern = (std::filesystem::temp_directory_path() / "nao_bench_XXXXXX").string();
    NAO_CHECK(::mkdtemp(pattern.data()) != nullptr);
    folder_ = pattern;
  }
  ~TemporaryFile() { std::filesystem::remove_all(folder_); }
  std::string path() const { return folder_ + "/run.rec"; }

 private:
  std::string folder_;
};

void record(benchmark::State& state, const char* robot, Client client, Duration turn) {
  constexpr int kTurnsAtOnce = 5;
  const int turns = static_cast<int>(60s / turn);
  for (auto _ : state) {
    const TemporaryFile file;
    const runtime::RunStart begin = start(robot);
    Simulation plain = begin.makeSimulation();
    Simulation recorded = begin.makeSimulation();
    runtime::Recorder recorder(file.path(), begin);
    const auto before = std::filesystem::file_size(file.path());
    recorded.watch(recorder);
    double without = 0;
    double with = 0;
    for (int k = 0; k < turns; k += kTurnsAtOnce) {
      without += advance(plain, client, turn, k, kTurnsAtOnce);
      with += advance(recorded, client, turn, k, kTurnsAtOnce);
    }
    recorder.finish(recorded);
    NAO_CHECK(plain.hash() == recorded.hash());
    const auto size = static_cast<double>(std::filesystem::file_size(file.path()) - before);
    state.counters["cost_percent"] = 100 * (with / without - 1);
    state.counters["mb_per_minute"] = size * 1e-6;
  }
}

void recordWalk(benchmark::State& state) { record(state, "nao_h21_v33", walk, 20ms); }
void recordDriven(benchmark::State& state) { record(state, "nao_h25_v60", drive, 12ms); }

BENCHMARK(recordWalk)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(recordDriven)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nao

BENCHMARK_MAIN();
