#include "validation/diagnosis/rig_simulator.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "core/random.h"
#include "validation/diagnosis/merge_effects.h"

namespace nao::validation {
namespace {

std::vector<double> meanOf(const GriddedMotion& motion,
                           std::map<Joint, std::vector<double>> GriddedMotion::Run::*signal,
                           Joint joint) {
  std::vector<double> sum(motion.rows, 0.0);
  for (const GriddedMotion::Run& run : motion.runs) {
    const std::vector<double>& values = (run.*signal).at(joint);
    for (std::size_t k = 0; k < motion.rows; ++k) sum[k] += values[k];
  }
  for (double& value : sum) value /= static_cast<double>(motion.runs.size());
  return sum;
}

// A number of its own for each stream of each motion.
std::uint64_t mixed(std::uint64_t stream, std::size_t motion) {
  return stream * 0x9e3779b97f4a7c15ULL + motion + 1;
}

// As the effect encoder_jitter.
void addJitter(double amplitude, std::uint64_t stream, Eigen::MatrixXd& signals) {
  if (amplitude <= 0) return;
  Random random(stream, "encoder");
  for (Eigen::Index k = 0; k < signals.rows(); ++k) {
    const double draw = random.uniform();
    if (draw < 0.25) signals(k, 0) -= amplitude;
    if (draw >= 0.75) signals(k, 0) += amplitude;
  }
}

RobotModel withGain(const RobotModel& model, Joint joint, double kp_scale) {
  RobotModel scaled = model;
  scaled.actuators[index(joint)].kp *= kp_scale;
  return scaled;
}

}  // namespace

RigSimulator::RigSimulator(std::shared_ptr<const RigSet> set, Joint joint)
    : set_(std::move(set)),
      joint_(joint),
      step_(set_->rigStep()),
      world_step_(set_->worldStep()),
      loads_(std::make_unique<LimbLoads>(*set_, joint, world_step_)) {
  for (const GriddedMotion& motion : set_->motions()) {
    measured_.push_back(measuredOf(motion));
    orders_.push_back({motion.runs.front().command.at(joint),
                       meanOf(motion, &GriddedMotion::Run::stiffness, joint)});
  }
  addRigs();
  if (set_->coarseStep() > step_) coarse_.reset(new RigSimulator(*this, set_->coarseStep()));
}

RigSimulator::RigSimulator(const RigSimulator& fine, Duration step)
    : set_(fine.set_),
      joint_(fine.joint_),
      step_(step),
      world_step_(step),
      measured_(fine.measured_),
      orders_(fine.orders_),
      loads_(std::make_unique<LimbLoads>(*set_, joint_, world_step_)) {
  addRigs();
}

void RigSimulator::addRigs() {
  for (const GriddedMotion& motion : set_->motions()) {
    rigs_.emplace_back(withGain(set_->model(), joint_, motion.kp_scale), joint_, set_->row(), step_,
                       loads_->others());
  }
}

RigSimulator::~RigSimulator() = default;

std::string RigSimulator::joint() const { return set_->model().actuators[index(joint_)].name; }

JointMotion RigSimulator::measuredOf(const GriddedMotion& motion) const {
  JointMotion found{motion.motion, motion.split, motion.dt, {}};
  const auto rows = static_cast<Eigen::Index>(motion.rows);
  const bool current =
      std::all_of(motion.runs.begin(), motion.runs.end(),
                  [&](const GriddedMotion::Run& run) { return run.current.count(joint_) > 0; });
  for (const GriddedMotion::Run& run : motion.runs) {
    if (run.command.count(joint_) == 0 || run.angle.count(joint_) == 0) {
      throw InputError(motion.motion + ": expected command and angle of " + joint() +
                       " in every run");
    }
    Eigen::MatrixXd signals(rows, current ? 2 : 1);
    signals.col(0) = Eigen::Map<const Eigen::VectorXd>(run.angle.at(joint_).data(), rows);
    if (current) {
      signals.col(1) = Eigen::Map<const Eigen::VectorXd>(run.current.at(joint_).data(), rows);
    }
    found.repeats.push_back(std::move(signals));
  }
  return found;
}

Eigen::MatrixXd RigSimulator::run(const std::vector<EffectSetting>& causes, std::size_t motion,
                                  std::uint64_t stream, const JointNoise& noise) const {
  const std::vector<EffectSetting> effects = set_->effectsWith(causes, set_->motions()[motion]);
  const auto load = loads_->get(motion, effects);
  sim::RigChance chance;
  chance.stream = mixed(stream, motion);
  chance.torque_sd = noise.torque_sd;
  if (noise.torque_time > 0) chance.torque_time = noise.torque_time;
  const double most = 0.9 * set_->options().settle;
  chance.lead = (toSeconds(step_) - toSeconds(world_step_)) / 2;
  chance.start = std::clamp(noise.start_sd * Random(chance.stream, "start").normal(), -most, most);
  const sim::JointSignals signals =
      rigs_[motion].run(effects, orders_[motion], *load, chance,
                        fromSeconds(set_->options().settle), set_->catalogue());
  const auto rows = static_cast<Eigen::Index>(signals.angle.size());
  Eigen::MatrixXd result(rows, measured_[motion].repeats.front().cols());
  result.col(0) = Eigen::Map<const Eigen::VectorXd>(signals.angle.data(), rows);
  addJitter(noise.jitter, chance.stream, result);
  if (noise.quantum > 0) {
    result.col(0) = noise.quantum * (result.col(0) / noise.quantum).array().round();
  }
  if (result.cols() > 1) {
    result.col(1) = Eigen::Map<const Eigen::VectorXd>(signals.current.data(), rows);
  }
  return result;
}

bool RigSimulator::isCoupled() const {
  const auto& limits = set_->model().coupled_limits;
  return std::any_of(limits.begin(), limits.end(),
                     [this](const CoupledLimit& limit) { return limit.limited == joint_; });
}

double RigSimulator::present(const std::string& effect, const std::string& parameter) const {
  return presentDeviation(set_->model(), index(joint_), effect, parameter, set_->catalogue());
}

}  // namespace nao::validation
