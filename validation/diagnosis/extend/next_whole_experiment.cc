#include "validation/diagnosis/extend/next_whole_experiment.h"

#include <algorithm>
#include <cmath>

#include "core/suspend.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/diagnosis/whole/whole_data.h"
#include "validation/log/floor_recording.h"

namespace nao::validation {
namespace {

constexpr int kRuns = 6;  // simulated per cause and motion

RecordedMotion standing(const std::shared_ptr<const RobotModel>& model, const FloorMotion& motion) {
  return {motion.name, Split::Fit, motion.duration,
          [model, motion](double t) { return calcFloorAngles(*model, motion, t); }};
}

// The candidates, and a nominal run of each whose commands are replayed.
struct Candidates {
  std::vector<RecordedMotion> motions;
  LogSet set;
  std::shared_ptr<const RobotModel> robot;
};

Candidates hungUp(const std::shared_ptr<const RobotModel>& model) {
  Candidates all;
  all.robot = model->fixed_base ? model : std::make_shared<RobotModel>(suspend(*model));
  all.motions = standardRecording(all.robot);
  for (RecordedMotion& motion : all.motions) motion.split = Split::Fit;
  RecordingPlan plan;
  plan.model = all.robot;
  plan.motions = all.motions;
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  all.set = recordSimulated(plan);
  return all;
}

Candidates onItsFeet(const std::shared_ptr<const RobotModel>& model) {
  Candidates all;
  all.robot = model;
  FloorPlan plan;
  plan.model = model;
  for (FloorMotion motion : standingMotions()) {
    motion.split = Split::Fit;
    plan.motions.push_back(motion);
    all.motions.push_back(standing(model, motion));
  }
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(2);
  all.set = recordOnFloor(plan);
  return all;
}

// Of two causes, in the signal that tells most.
double separationOf(const RunSpread& a, const RunSpread& b, const FeatureSpace& space,
                    int repeats) {
  double most = 0;
  for (const FeatureGroup& group : space.groups()) {
    const auto part = [&](const Eigen::VectorXd& all) {
      return all.segment(group.offset, group.size);
    };
    const double square = (part(a.mean) - part(b.mean)).squaredNorm();
    const double chance = (part(a.variance) + part(b.variance)).sum() / 2 / repeats;
    const double floor = group.floor * group.floor * static_cast<double>(group.size);
    most = std::max(most, std::sqrt(square / std::max(chance + floor, 1e-12)));
  }
  return most;
}

double leastSeparation(const std::vector<RunSpread>& causes, const FeatureSpace& space,
                       int repeats) {
  double least = 1e9;
  for (std::size_t a = 0; a < causes.size(); ++a) {
    for (std::size_t b = a + 1; b < causes.size(); ++b) {
      least = std::min(least, separationOf(causes[a], causes[b], space, repeats));
    }
  }
  return least;
}

}  // namespace

std::vector<PlannedMotion> planWholeExperiments(const std::shared_ptr<const RobotModel>& model,
                                                const Ambiguity& ambiguous, int repeats, int jobs) {
  const bool stands = ambiguous.level == "robot" && !model->fixed_base;
  const Candidates all = stands ? onItsFeet(model) : hungUp(model);
  const WholeSimulator simulator(all.set, all.robot);
  const WholeData data(simulator, simulator.judged(), stands);
  std::vector<WholePool> runs;
  for (const EffectSetting& setting : ambiguous.settings) {
    runs.push_back(data.simulate({setting}, kRuns, 1, Blocks::Fit, 1, 1, jobs, Pace::Coarse));
  }
  std::vector<PlannedMotion> experiments;
  for (std::size_t b = 0; b < simulator.blocks().size(); ++b) {
    const WholeBlock& block = simulator.blocks()[b];
    std::vector<RunSpread> causes;
    for (const WholePool& pool : runs) {
      const auto& played = pool[block.runs.front()];
      causes.push_back(spreadOf({played.begin(), played.end()}, 0));
    }
    const auto motion = std::find_if(all.motions.begin(), all.motions.end(),
                                     [&](const auto& one) { return one.name == block.motion; });
    experiments.push_back({*motion, leastSeparation(causes, data.spaces()[b], repeats)});
  }
  std::stable_sort(experiments.begin(), experiments.end(), separatesMore);
  return experiments;
}

}  // namespace nao::validation
