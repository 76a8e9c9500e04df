// What each effect costs: processor time per 2 ms step of a standing nao_h21_v33_ideal, sensors
// read once per cycle, alone and with one effect at its nominal values on all joints. Every round
// measures the plain robot beside the other: `adds_us` is the median of the differences.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

#include "sim/effects/catalogue.h"
#include "sim/world.h"

namespace nao {
namespace {

using std::chrono_literals::operator""ms;

constexpr int kCycles = 100;  // per round
constexpr int kStepsPerCycle = 5;

double processorTime() {  // [s]
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Standing {
 public:
  explicit Standing(std::vector<EffectSetting> effects) {
    auto model = std::make_shared<RobotModel>(
        *loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33_ideal"));
    model->effects = std::move(effects);
    command_ = {model->findPosture("StandInit")->angle,
                JointArray<double>(model->jointCount(), 1.0)};
    world_ = std::make_unique<sim::World>(
        std::make_shared<WorldModel>(), std::vector<sim::RobotSetup>{{"nao", std::move(model), {}}},
        sim::WorldOptions(2ms));
    world_->placeRobot(0, {}, &command_.angle);
  }

  double secondsPerStep() {
    const double begin = processorTime();
    for (int k = 0; k < kCycles; ++k) {
      benchmark::DoNotOptimize(world_->readSensors(0));
      world_->setCommand(0, command_);
      for (int i = 0; i < kStepsPerCycle; ++i) world_->step();
    }
    return (processorTime() - begin) / (kCycles * kStepsPerCycle);
  }

 private:
  JointCommand command_;
  std::unique_ptr<sim::World> world_;
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void cost(benchmark::State& state, const std::vector<EffectSetting>& effects) {
  Standing plain({}), with(effects);
  plain.secondsPerStep();  // settles
  with.secondsPerStep();
  std::vector<double> steps, differences;
  for (auto _ : state) {
    const double before = plain.secondsPerStep();
    const double after = with.secondsPerStep();
    state.SetIterationTime(after * kCycles * kStepsPerCycle);
    steps.push_back(before * 1e6);
    differences.push_back((after - before) * 1e6);
  }
  state.counters["step_us"] = median(steps);
  state.counters["adds_us"] = median(differences);
  state.counters["adds_percent"] = 100 * median(differences) / median(steps);
}

void addBenchmark(const std::string& name, const std::vector<EffectSetting>& effects) {
  benchmark::RegisterBenchmark(name.c_str(), cost, effects)
      ->UseManualTime()
      ->Iterations(100)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace nao

int main(int argc, char** argv) {
  const auto documented = nao::loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
  nao::addBenchmark("documented", documented->effects);
  for (const nao::sim::EffectType& type : nao::sim::standardEffects().types()) {
    nao::addBenchmark(type.name, {{type.name, {}, {}, ""}});
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
