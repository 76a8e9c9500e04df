#include <algorithm>
#include <cmath>

#include "tests/hidden/trial.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/merge_effects.h"
#include "validation/suspended.h"

namespace nao::hidden {
namespace {

using namespace validation;  // NOLINT: a file of glue

constexpr int kRuns = 24;          // of each test motion: four times the measured ones
constexpr double kVisible = 1.15;  // misfit of the nominal model below which nothing is to remove

std::vector<EffectSetting> settingsOf(const GivenReport& report, const RobotModel& model) {
  std::vector<EffectSetting> settings;
  std::vector<GivenCause> told = report.causes;
  told.insert(told.end(), report.adjustments.begin(), report.adjustments.end());
  for (const GivenCause& cause : told) {
    if (!cause.has_number || cause.effect.empty()) continue;
    EffectSetting setting = neutralSetting(cause.effect, sim::standardEffects());
    setting.parameters[cause.parameter] = cause.value;
    for (const auto& [name, value] : cause.shape) setting.parameters[name] = value;
    if (!cause.joint.empty()) setting.joints = {*model.findJoint(cause.joint)};
    settings.push_back(setting);
  }
  return settings;
}

}  // namespace

Gain calcGain(const LogSet& set, const Truth& truth, const GivenReport& report,
              const RobotModel& nominal) {
  const auto model = std::make_shared<RobotModel>(nominal);
  const auto rigs = std::make_shared<const RigSet>(set, model);
  const JointNoise noise{truth.torque_sd, truth.torque_time, truth.start_sd, 0};
  const std::vector<EffectSetting> causes = settingsOf(report, rigs->model());
  double before = 0, after = 0, floor = 0;  // [rad^2] over all joints
  for (const Joint joint : rigs->joints()) {
    const RigSimulator simulator(rigs, joint);
    const auto replay = [&](const std::vector<EffectSetting>& with) {
      return replayJoint(simulator.exact(), with, noise, kRuns, {Split::Test});
    };
    const JointReplay nominal_replay = replay({});
    const JointReplay extended = causes.empty() ? nominal_replay : replay(causes);
    const double noise_rms = extended.rmse / std::max(extended.misfit, 1e-9);
    before += nominal_replay.rmse * nominal_replay.rmse;
    after += extended.rmse * extended.rmse;
    floor += noise_rms * noise_rms;
  }
  Gain gain;
  gain.known = before > kVisible * kVisible * floor;
  gain.over_floor = std::sqrt(after / floor);
  gain.removed = gain.known ? (before - std::max(after, floor)) / (before - floor) : 0;
  return gain;
}

}  // namespace nao::hidden
