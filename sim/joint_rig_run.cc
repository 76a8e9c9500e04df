#include "sim/joint_rig_run.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace nao::sim {
namespace {

constexpr int kMaxSolves = 6;   // as RobotBody
constexpr double kNear = 0.06;  // [rad] a little more than JointStops

// The torque changes linearly over this part of its correlation time: a mean of 3 % less variance,
// which is given back.
constexpr double kSampling = 0.1;

double valueAt(const std::vector<double>& values, double place) {
  if (place <= 0) return values.front();
  const auto before = static_cast<std::size_t>(place);
  if (before + 1 >= values.size()) return values.back();
  return values[before] +
         (place - static_cast<double>(before)) * (values[before + 1] - values[before]);
}

const WorldModel& noWorld() {
  static const WorldModel world;
  return world;
}

}  // namespace

RigTorque::RigTorque(const RigChance& chance, double h)
    : random_(chance.stream, "torque", chance.pair) {
  if (chance.torque_sd <= 0) return;
  steps_ = std::max(1L, std::lround(kSampling * chance.torque_time / h));
  keep_ = std::exp(-static_cast<double>(steps_) * h / chance.torque_time);
  const auto n = static_cast<double>(steps_);
  // Of the mean over the n steps s = i/n of the variance (1-s)^2 + s^2 + 2 s (1-s) keep.
  const double mixed = (n * n - 1) / (6 * n * n);  // mean of s (1-s)
  const double sd = chance.torque_sd / std::sqrt(1 - 2 * mixed * (1 - keep_));
  fresh_ = sd * std::sqrt(1 - keep_ * keep_);
  sample_ = sd * random_.normal();
}

double RigTorque::next() {
  if (left_ == 0) {
    torque_ = sample_;
    sample_ = keep_ * sample_ + fresh_ * random_.normal();
    change_ = (sample_ - torque_) / static_cast<double>(steps_);
    left_ = steps_;
  }
  --left_;
  const double torque = torque_;
  torque_ += change_;
  return torque;
}

void JointRigRun::Line::go(const std::vector<double>& values, double place, double steps) {
  now = valueAt(values, place);
  change = (valueAt(values, place + 1) - now) / steps;
}

BodyPlan JointRigRun::makePlan(const RobotModel& model, EffectChain& effects) {
  BodyPlan plan(model, noWorld());
  effects.alterPlan(plan);
  return plan;
}

JointRigRun::JointRigRun(const RobotModel& model, Duration step, EffectChain& effects,
                         const JointOrders& orders, const JointLoad& load, const RigChance& chance)
    : step_(step),
      h_(toSeconds(step)),
      effects_(effects),
      orders_(orders),
      load_(load),
      plan_(makePlan(model, effects)),
      motor_(plan_, 0),
      rotor_(motor_.soft() ? 0 : plan_.model.actuators[0].rotor_inertia),
      stops_(plan_.model, 0),
      lower_(plan_.model.coordinates[0].lower + kNear),
      upper_(plan_.model.coordinates[0].upper - kNear),
      heat_(model),
      torque_(chance, h_),
      until_order_(static_cast<double>(model.cycle / step) + (chance.start - chance.lead) / h_),
      late_(chance.start * load.per_row / toSeconds(model.cycle)),
      q_(orders.angle[0] + plan_.joint_zero[0]),
      angle_(model.jointCount()),
      rate_(model.jointCount()),
      motor_torque_(model.jointCount()),
      gear_torque_(model.jointCount()),
      angles_(model.jointCount()),
      rates_(model.jointCount()),
      system_(std::vector<int>(model.jointCount(), -1)),
      du_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.jointCount()))) {
  motor_.reset(q_);
  sent_.angle = JointArray<double>(model.jointCount(), orders.angle[0]);
  sent_.stiffness =
      JointArray<double>(model.jointCount(), orders.stiffness.empty() ? 1 : orders.stiffness[0]);
  followed_ = sent_;
  frame_.angle = JointArray<double>(model.jointCount());
  const auto& limits = plan_.model.coupled_limits;
  if (std::none_of(limits.begin(), limits.end(), [](const auto& limit) { return limit.stop; })) {
    return;
  }
  lower_ = 1, upper_ = -1;  // look at them always
  for (std::size_t j = 1; j < model.jointCount(); ++j) {
    const auto other = load.others.find(model.actuators[j].name);
    NAO_CHECK(other != load.others.end() && other->second.size() == load.torque.size());
    others_.push_back({&other->second, {}});
  }
}

JointSignals JointRigRun::all(Duration settle) {
  const std::size_t rows = orders_.angle.size();
  JointSignals signals;
  signals.angle.reserve(rows);
  signals.current.reserve(rows);
  inertia_.hold(load_.inertia);
  bias_.hold(load_.torque);
  reference_.hold(load_.reference);
  slope_.hold(load_.slope);
  for (Other& other : others_) other.line.hold(*other.angle);
  const long row_steps = plan_.model.cycle / step_;
  const long settle_rows = settle / plan_.model.cycle;
  until_order_ += static_cast<double>(settle_rows * row_steps);
  JointSignals before;
  for (long i = 0; i < settle_rows; ++i) {
    report(before);
    steps(row_steps);
  }
  const long part_steps = row_steps / load_.per_row;
  for (std::size_t k = 0;; ++k) {
    if (k % static_cast<std::size_t>(load_.per_row) == 0) report(signals);
    if (signals.angle.size() == rows) return signals;
    const auto n = static_cast<double>(part_steps);
    const double place = static_cast<double>(k) - late_;
    inertia_.go(load_.inertia, place, n);
    bias_.go(load_.torque, place, n);
    reference_.go(load_.reference, place, n);
    slope_.go(load_.slope, place, n);
    for (Other& other : others_) other.line.go(*other.angle, place, n);
    steps(part_steps);
  }
}

void JointRigRun::steps(long count) {
  for (; count > 0; --count) step();
}

// An order that comes within the step acts in proportion to what is left of it.
void JointRigRun::order() {
  followed_.angle[0] = sent_.angle[0];
  followed_.stiffness[0] = sent_.stiffness[0];
  constexpr double kRounding = 1e-9;
  const auto k = static_cast<std::size_t>(next_order_);
  if (until_order_ < 1 - kRounding && k < orders_.angle.size()) {
    sent_.angle[0] = orders_.angle[k];
    if (!orders_.stiffness.empty()) sent_.stiffness[0] = orders_.stiffness[k];
    const double old = until_order_ > kRounding ? until_order_ : 0;
    followed_.angle[0] = old * followed_.angle[0] + (1 - old) * sent_.angle[0];
    followed_.stiffness[0] = sent_.stiffness[0];
    until_order_ += static_cast<double>(plan_.model.cycle / step_);
    ++next_order_;
  }
  until_order_ -= 1;
  if (effects_.actsOnCommand()) effects_.alterCommand(followed_, now_, h_);
}

const DriveTerms* JointRigRun::calcTerms() {
  if (!effects_.actsOnDrive()) return nullptr;
  angle_[0] = motor_.angle();
  rate_[0] = motor_.rate();
  motor_torque_[0] = motor_.torque();
  gear_torque_[0] = motor_.load();
  effects_.alterDrive(
      {now_, h_, angle_, rate_, followed_.angle, followed_.stiffness, motor_torque_, gear_torque_},
      terms_);
  return &terms_;
}

void JointRigRun::step() {
  order();
  GearedMotor::Input input;
  input.h = h_;
  input.q = q_;
  input.u = u_;
  if (const DriveTerms* terms = calcTerms()) input.take(*terms, 0);
  if (torque_.acts()) input.disturbance += torque_.next();
  input.command = followed_.angle[0];
  input.stiffness = followed_.stiffness[0];
  input.open = input.stiffness < 0;
  motor_.prepare(input);
  const double bias = bias_.next() + slope_.next() * (q_ - reference_.next());
  solve(bias, inertia_.next());
  motor_.finish(du_[0]);
  u_ += du_[0];
  q_ += h_ * u_;
  motor_.observe(q_, u_);
  now_ += step_;
}

void JointRigRun::solve(double bias, double inertia) {
  const double next = q_ + h_ * u_;
  const bool near = next > upper_ || next < lower_;
  if (near) {
    angles_[0] = q_;
    rates_[0] = u_;
    for (std::size_t i = 0; i < others_.size(); ++i) angles_[i + 1] = others_[i].line.now;
    stops_.prepare(angles_.data(), rates_.data(), h_);
  }
  for (Other& other : others_) other.line.next();
  for (int solves = 1;; ++solves) {
    double push = h_ * (motor_.now() - bias);
    double mass = inertia + rotor_ + h_ * motor_.change();
    if (near) {
      du_[0] = push;
      system_.at(0, 0) = mass;
      stops_.addTo(system_, du_);
      push = du_[0];
      mass = system_.at(0, 0);
    }
    du_[0] = push / mass;
    const bool motor_changed = motor_.revise(du_[0]);
    const bool stops_changed = near && stops_.revise(du_);
    if (!(motor_changed || stops_changed) || solves == kMaxSolves) return;
  }
}

void JointRigRun::report(JointSignals& signals) {
  frame_.time = now_;
  frame_.angle[0] = motor_.angle();
  motor_torque_[0] = motor_.torque();
  heat_.sample(motor_torque_, toSeconds(plan_.model.cycle), frame_);
  effects_.alterSensors(frame_, plan_.model.cycle);
  signals.angle.push_back(frame_.angle[0]);
  signals.current.push_back(frame_.current[0]);
}

}  // namespace nao::sim
