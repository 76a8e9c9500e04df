#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/diagnosis/rig/run_load.h"
#include "validation/log/series.h"
#include "validation/log/standard_motions.h"
#include "validation/merge_effects.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// All that its encoder read; of a blind set, which has nothing else, in test runs.
std::vector<double> anglesOf(const LogSet& set, const std::string& joint) {
  std::vector<double> seen, blind;
  for (const LogRun& run : set.runs) {
    const Column* q = run.find("q." + joint);
    if (q == nullptr) continue;
    std::vector<double>& angles = run.split == Split::Test ? blind : seen;
    angles.insert(angles.end(), q->begin(), q->end());
  }
  return seen.empty() ? blind : seen;
}

}  // namespace

RigSet::RigSet(const LogSet& set, std::shared_ptr<const RobotModel> model, RigOptions options)
    : model_(std::make_shared<RobotModel>(*model)), options_(options) {
  if (!model_->fixed_base) {
    if (!set.environment.suspended) {
      throw InputError(set.name + ": expected a suspended robot, found one on its feet");
    }
    *model_ = suspend(*model_);
  }
  *model_ = stripped(*model_);
  motions_ = griddedMotions(set, *model_);
  if (motions_.empty()) throw InputError(set.name + ": expected at least one run");
  choosePace(motions_.front().dt);
  findJoints();
  layCounts(set);
  for (const GriddedMotion& motion : motions_) measured_.push_back(meanOf(motion));
}

const sim::EffectCatalogue& RigSet::catalogue() const {
  return options_.catalogue ? *options_.catalogue : sim::standardEffects();
}

void RigSet::choosePace(double dt) {
  constexpr double kValue = 1e-3;  // [s] between values of the loads, about
  const auto parts = [](double whole, double most) { return std::ceil(whole / most - 1e-6); };
  per_row_ = std::max(1, static_cast<int>(std::lround(dt / kValue)));
  const double value = dt / per_row_;
  const double world = parts(value, options_.world_step), rig = parts(value, options_.step);
  const Duration tick = fromSeconds(value / (world * rig));
  world_step_ = tick * std::lround(rig);
  rig_step_ = tick * std::lround(world);
  const long ticks = std::lround(world * rig);
  const auto dividing = [&](double most) {
    long steps = std::lround(parts(value, most));
    while (ticks % steps != 0) ++steps;
    return tick * (ticks / steps);
  };
  coarse_step_ = dividing(options_.coarse_step);
  rough_step_ = dividing(options_.rough_step);
  model_->cycle = per_row_ * std::lround(world) * world_step_;
}

void RigSet::findJoints() {
  for (std::size_t j = 0; j < model_->jointCount(); ++j) {
    const Joint joint = toJoint(j);
    const auto whole = [joint](const GriddedMotion::Run& run) {
      return run.command.count(joint) > 0 && run.angle.count(joint) > 0;
    };
    const bool all = std::all_of(motions_.begin(), motions_.end(), [&](const GriddedMotion& m) {
      return std::all_of(m.runs.begin(), m.runs.end(), whole);
    });
    if (all && !model_->actuators[j].coordinates.empty()) joints_.push_back(joint);
  }
}

// A joint that rests reads the same count in every repeat: off by up to half of one where a zero
// that was set in software is not known.
void RigSet::layCounts(const LogSet& set) {
  constexpr char kCounts[] = "encoder_quantum";
  std::vector<EffectSetting> beside;
  for (const Joint joint : joints_) {
    const double quantum = presentDeviation(*model_, index(joint), kCounts, "quantum", catalogue());
    if (quantum <= 0) continue;
    const double phase = findPhase(anglesOf(set, model_->actuators[index(joint)].name), quantum);
    if (phase != 0) beside.push_back({kCounts, {{"quantum", 0}, {"phase", phase}}, {joint}, ""});
  }
  model_->effects = mergedEffects(*model_, beside, catalogue());
}

MeasuredMotion RigSet::meanOf(const GriddedMotion& motion) const {
  const auto rows = static_cast<Eigen::Index>(motion.rows);
  const auto joints = static_cast<Eigen::Index>(model_->jointCount());
  MeasuredMotion mean{motion.dt, Eigen::MatrixXd::Zero(rows, joints),
                      std::vector<bool>(model_->jointCount(), false)};
  const auto pose = startPose(*model_, motion.start_pose);  // of what was neither moved nor written
  for (Eigen::Index j = 0; j < joints; ++j) {
    const Joint joint = toJoint(static_cast<std::size_t>(j));
    std::vector<Eigen::VectorXd> runs;
    for (const GriddedMotion::Run& run : motion.runs) {
      const auto at = run.angle.find(joint);
      if (at != run.angle.end()) {
        runs.push_back(Eigen::Map<const Eigen::VectorXd>(at->second.data(), rows));
      }
    }
    if (runs.empty()) {
      if (!pose && !model_->actuators[index(joint)].coordinates.empty()) {
        rejectStartPose(*model_, motion.motion, motion.start_pose);
      }
      mean.assumed[index(joint)] = true;
      if (pose) mean.angle.col(j).setConstant((*pose)[joint]);
      continue;
    }
    const auto count = static_cast<double>(runs.size());
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(rows);
    for (const Eigen::VectorXd& run : runs) sum += run;
    mean.angle.col(j) = sum / count;
  }
  return mean;
}

std::vector<EffectSetting> RigSet::effectsWith(const std::vector<EffectSetting>& causes,
                                               const GriddedMotion& motion) const {
  std::vector<EffectSetting> effects = mergedEffects(*model_, causes, catalogue());
  if (!motion.load) return effects;
  if (auto payload = effectOf(*motion.load, *model_)) effects.push_back(std::move(*payload));
  return effects;
}

}  // namespace nao::validation
