#include "validation/diagnosis/rig/rig_simulator.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "validation/diagnosis/rig/led_joint.h"
#include "validation/diagnosis/rig/run_noise.h"
#include "validation/diagnosis/rig/touched_lines.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

Eigen::VectorXd asVector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

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

RobotModel withGain(const RobotModel& model, Joint joint, double kp_scale) {
  RobotModel scaled = model;
  scaled.actuators[index(joint)].kp *= kp_scale;
  return scaled;
}

// Values of coarse loads: every other of the fine ones.
int coarsePerRow(const RigSet& set) {
  return set.perRow() % 2 == 0 ? set.perRow() / 2 : set.perRow();
}

// Between motor and link: what the link does is not what the motor says, and no slope about the
// motor's motion tells its load.
bool partsLinkFromMotor(const std::string& effect) {
  return effect == "backlash" || effect == "gear_compliance";
}

// Causes that act on the load itself.
std::vector<EffectSetting> loadingOf(const std::vector<EffectSetting>& causes,
                                     const sim::EffectCatalogue& catalogue) {
  std::vector<EffectSetting> kept;
  for (const EffectSetting& cause : causes) {
    const sim::EffectType* type = catalogue.find(cause.name);
    if (type == nullptr) continue;
    if (sim::reachOf(*type) == sim::JointReach::Load || partsLinkFromMotor(cause.name)) {
      kept.push_back(cause);
    }
  }
  return kept;
}

// That looks at masses share: of seven motions two draws. Of a leg they take 500 kB each.
constexpr std::size_t kMotions = 16;

// [rad] By which a joint may sag under a weight and still move as it does without: over it what
// gravity does to its torque bends by half a percent, beside the slope that is part of a load.
constexpr double kSag = 0.1;

double torqueBetween(const sim::JointLoad& a, const sim::JointLoad& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.torque.size(); ++i) {
    most = std::max(most, std::abs(a.torque[i] - b.torque[i]));
  }
  return most;
}

std::vector<EffectSetting> partingOf(const std::vector<EffectSetting>& causes) {
  std::vector<EffectSetting> kept;
  for (const EffectSetting& cause : causes) {
    if (partsLinkFromMotor(cause.name)) kept.push_back(cause);
  }
  return kept;
}

}  // namespace

RigSimulator::RigSimulator(std::shared_ptr<const RigSet> set, Joint joint)
    : set_(std::move(set)),
      joint_(joint),
      step_(set_->rigStep()),
      world_step_(set_->worldStep()),
      limb_(std::make_shared<Limb>(*set_, joint)),
      loads_(std::make_unique<LimbLoads>(limb_, world_step_, set_->perRow())) {
  for (const GriddedMotion& motion : set_->motions()) {
    measured_.push_back(measuredOf(motion));
    orders_.push_back({motion.runs.front().command.at(joint),
                       meanOf(motion, &GriddedMotion::Run::stiffness, joint)});
  }
  addRigs();
  exact_ = std::make_unique<LimbSimulator>(limb_, measured_);
  const Duration coarse = std::max(step_, set_->coarseStep());
  if (coarse > step_) coarse_.reset(new RigSimulator(*this, coarse, Loads::Drawn));
  rough_.reset(new RigSimulator(*this, std::max(coarse, set_->roughStep()), Loads::OfMassOnly));
}

RigSimulator::RigSimulator(const RigSimulator& fine, Duration step, Loads of)
    : set_(fine.set_),
      joint_(fine.joint_),
      step_(step),
      world_step_(step),
      measured_(fine.measured_),
      orders_(fine.orders_),
      limb_(fine.limb_),
      loads_(std::make_unique<LimbLoads>(limb_, set_->row() / set_->perRow(), coarsePerRow(*set_),
                                         of == Loads::OfMassOnly ? kMotions : 0)),
      loads_of_(of) {
  addRigs();
}

void RigSimulator::addRigs() {
  for (const GriddedMotion& motion : set_->motions()) {
    rigs_.emplace_back(withGain(set_->model(), joint_, motion.kp_scale), joint_, set_->row(), step_,
                       loads_->others());
  }
}

RigSimulator::~RigSimulator() = default;

const JointSimulator& RigSimulator::rough() const {
  if (rough_) return *rough_;
  return *this;
}

const JointSimulator& RigSimulator::exact() const {
  if (exact_) return *exact_;
  return *this;
}

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

std::shared_ptr<const sim::JointLoad> RigSimulator::loadOf(const std::vector<EffectSetting>& causes,
                                                           std::size_t motion, std::uint64_t stream,
                                                           const JointNoise& noise) const {
  const bool drawn = loads_of_ != Loads::Quiet && noise.torque_sd > 0;
  const std::uint64_t draw = drawn ? 1 + stream % 2 : 0;
  const auto with = [&](const std::vector<EffectSetting>& some) {
    return set_->effectsWith(some, set_->motions()[motion]);
  };
  if (loads_of_ != Loads::OfMassOnly) {
    return loads_->get(motion, with(causes), with(causes), draw, noise);
  }
  const std::vector<EffectSetting> seen = loadingOf(causes, set_->catalogue());
  const auto along = with(partingOf(seen));
  const auto load = loads_->get(motion, with(seen), along, draw, noise);
  const auto without = loads_->get(motion, along, along, draw, noise);
  const double most = kSag * set_->model().actuators[index(joint_)].kp;
  const bool sags = torqueBetween(*load, *without) > most;
  return sags ? loads_->get(motion, with(seen), with(seen), draw, noise) : load;
}

Eigen::MatrixXd RigSimulator::run(const std::vector<EffectSetting>& causes, std::size_t motion,
                                  std::uint64_t stream, const JointNoise& noise) const {
  const std::vector<EffectSetting> effects = set_->effectsWith(causes, set_->motions()[motion]);
  const auto load = loadOf(causes, motion, stream, noise);
  sim::RigChance chance;
  const RunDraw draw = drawOf(stream, motion);
  chance.stream = draw.seed;
  chance.pair = draw.pair;
  chance.torque_sd = noise.torque_sd;
  if (noise.torque_time > 0) chance.torque_time = noise.torque_time;
  chance.lead = (toSeconds(step_) - toSeconds(world_step_)) / 2;
  chance.start = drawLateness(noise, draw, 0.9 * set_->options().settle);
  const sim::JointSignals signals =
      rigs_[motion].run(effects, orders_[motion], *load, chance,
                        fromSeconds(set_->options().settle), set_->catalogue());
  const auto rows = static_cast<Eigen::Index>(signals.angle.size());
  Eigen::MatrixXd result(rows, measured_[motion].repeats.front().cols());
  result.col(0) = Eigen::Map<const Eigen::VectorXd>(signals.angle.data(), rows);
  addEncoderNoise(noise, draw, result);
  if (result.cols() > 1) {
    result.col(1) = Eigen::Map<const Eigen::VectorXd>(signals.current.data(), rows);
  }
  return result;
}

// Motor and link as one: the motor is what is told of, and the link what a torque acts on.
LedRun RigSimulator::led(const std::vector<EffectSetting>& causes, std::size_t motion,
                         const Eigen::VectorXd& off, const Eigen::VectorXd& misread) const {
  std::vector<EffectSetting> effects = set_->effectsWith(causes, set_->motions()[motion]);
  const auto parts = [](const EffectSetting& one) { return partsLinkFromMotor(one.name); };
  effects.erase(std::remove_if(effects.begin(), effects.end(), parts), effects.end());
  effects.push_back({LedJoint::kName, {}, {joint_}, ""});
  const Actuator& motor = set_->model().actuators[index(joint_)];
  const double inertia = motor.rotor_inertia * (1 + linkInertia());
  const double settle = set_->options().settle;
  LedJoint led(off, misread, toSeconds(set_->row()), settle, inertia, motor);
  const auto load = loadOf(causes, motion, 0, {});
  for (const sim::EffectCatalogue& catalogue :
       {led.watch(set_->catalogue()), led.lead(set_->catalogue())}) {
    rigs_[motion].run(effects, orders_[motion], *load, {}, fromSeconds(settle), catalogue);
  }
  return led.found();
}

bool RigSimulator::isCoupled() const {
  const auto& limits = set_->model().coupled_limits;
  return std::any_of(limits.begin(), limits.end(),
                     [this](const CoupledLimit& limit) { return limit.limited == joint_; });
}

std::vector<std::vector<double>> RigSimulator::touchedLines(bool upper) const {
  const auto end = endOf(set_->model(), joint_, upper, set_->catalogue());
  if (!end || !isCoupled()) return {};
  std::vector<std::vector<StopApproach>> motions;
  for (const GriddedMotion& motion : set_->motions()) {
    if (motion.split != Split::Fit) continue;
    motions.emplace_back();
    for (const GriddedMotion::Run& run : motion.runs) {
      const auto other = run.angle.find(end->other), stopped = run.angle.find(joint_);
      if (other == run.angle.end() || stopped == run.angle.end()) continue;
      motions.back().push_back({asVector(other->second), end->left(asVector(stopped->second))});
    }
  }
  return validation::touchedLines(motions);
}

std::pair<double, double> RigSimulator::range() const {
  const int first = set_->model().actuators[index(joint_)].coordinates.front();
  const Coordinate& hinge = set_->model().coordinates[static_cast<std::size_t>(first)];
  return {hinge.lower, hinge.upper};
}

double RigSimulator::present(const std::string& effect, const std::string& parameter) const {
  return presentDeviation(set_->model(), index(joint_), effect, parameter, set_->catalogue());
}

}  // namespace nao::validation
