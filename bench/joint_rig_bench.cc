// A run of 6 s of one joint with all of its robot's effects and noise, as a diagnosis makes
// thousands: knee and ankle roll, at steps of 1 and 0.25 ms.
#include <benchmark/benchmark.h>

#include <cmath>

#include "sim/joint_rig.h"

namespace nao {
namespace {

constexpr int kRows = 601;  // of 10 ms

void run(benchmark::State& state, const char* joint, std::vector<EffectSetting> causes) {
  static const auto model = loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33");
  const Duration step(state.range(0) * 1000);
  const sim::JointRig rig(*model, *model->findJoint(joint), model->cycle, step);
  sim::JointOrders orders;
  for (int k = 0; k < kRows; ++k) orders.angle.push_back(0.3 + 0.3 * std::sin(0.03 * k));
  sim::JointLoad load;
  load.inertia.assign(kRows, 0.01);
  load.torque.assign(kRows, 0.3);
  load.slope.assign(kRows, 0.5);
  load.reference = orders.angle;
  sim::RigChance chance;
  chance.torque_sd = 0.03;
  causes.insert(causes.begin(), model->effects.begin(), model->effects.end());
  for (auto _ : state) {
    ++chance.stream;
    benchmark::DoNotOptimize(rig.run(causes, orders, load, chance, std::chrono::milliseconds(500)));
  }
}

}  // namespace
}  // namespace nao

int main(int argc, char** argv) {
  using nao::EffectSetting;
  const std::vector<EffectSetting> friction{{"coulomb_friction", {}, {}, ""},
                                            {"viscous_friction", {}, {}, ""},
                                            {"load_friction", {}, {}, ""}};
  const std::pair<const char*, std::vector<EffectSetting>> all[] = {
      {"as the robot is", {}}, {"with three frictions", friction}};
  for (const auto& [name, causes] : all) {
    benchmark::RegisterBenchmark((std::string("LKneePitch ") + name).c_str(), nao::run,
                                 "LKneePitch", causes)
        ->ArgName("step_us")
        ->Arg(1000)
        ->Arg(500)
        ->Arg(250)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
