// A run of 6 s of a limb in a World of its own at 0.25 ms, as a diagnosis makes hundreds: processor
// time per step, ideal and with dry friction and process noise.
#include <benchmark/benchmark.h>

#include <cmath>

#include "core/suspend.h"
#include "sim/hinge_run.h"
#include "validation/suspended.h"

namespace nao {
namespace {

constexpr int kRows = 601;  // of 10 ms
constexpr Duration kStep = std::chrono::microseconds(250);

std::vector<JointCommand> swinging(const RobotModel& limb) {
  std::vector<JointCommand> orders;
  for (int k = 0; k < kRows; ++k) {
    orders.push_back(
        {JointArray<double>(limb.jointCount()), JointArray<double>(limb.jointCount(), 1.0)});
    for (std::size_t j = 0; j < limb.jointCount(); ++j) {
      orders.back().angle[j] = 0.2 * std::sin(0.03 * k + static_cast<double>(j));
    }
  }
  return orders;
}

void run(benchmark::State& state, const char* joint, bool effects) {
  const RobotModel robot =
      validation::stripped(suspend(*loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33")));
  const RobotModel limb =
      validation::cutLimbOf(robot, joint, JointArray<double>(robot.jointCount()));
  const std::vector<JointCommand> orders = swinging(limb);
  std::vector<EffectSetting> acting;
  if (effects) {
    acting = {{"coulomb_friction", {}, {}, ""}, {"process_noise", {}, {}, ""}};
  }
  sim::HingeRun how;
  how.step = kStep;
  for (auto _ : state) {
    ++how.seed;
    benchmark::DoNotOptimize(sim::runHinges(limb, acting, orders, how));
  }
  const double steps = static_cast<double>((kRows - 1) * (limb.cycle / kStep));
  state.counters["step_us"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * steps * 1e-6,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

}  // namespace
}  // namespace nao

int main(int argc, char** argv) {
  for (const char* joint : {"LKneePitch", "LElbowRoll"}) {
    for (const bool effects : {false, true}) {
      benchmark::RegisterBenchmark(
          (std::string(joint) + (effects ? " with friction and noise" : " ideal")).c_str(),
          nao::run, joint, effects)
          ->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
