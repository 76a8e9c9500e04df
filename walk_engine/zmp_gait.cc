#include "walk_engine/zmp_gait.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "walk_engine/balance.h"
#include "walk_engine/com_planner.h"
#include "walk_engine/footstep_plan.h"
#include "walk_engine/levelling.h"
#include "walk_engine/rise.h"
#include "walk_engine/servo_lead.h"
#include "walk_engine/stance.h"
#include "walk_engine/step_rules.h"
#include "walk_engine/sway.h"
#include "walk_engine/swing.h"

namespace nao::walk {
namespace {

using motion::GaitConfig;
using motion::Velocity2;

constexpr double kGravity = 9.80665;  // [m/s^2]
constexpr double kCommitted = 0.8;    // of a swing: later its landing stays; free, 0.7-0.9
constexpr double kCatchSpeed = 1.0;   // [m/s] at which a landing moves at most; free
constexpr double kOverlap = 0.4;      // [s] the rise may still take when the weight begins to move
constexpr double kTouch = 3;          // [N] a foot that bears this has landed: noise is below 1 N
constexpr double kAtRest = 0.002;     // [m/s] of the centre of mass

// Arms where they hang while standing, for the height of the centre of mass.
JointArray<double> standingAngles(const RobotModel& model) {
  const Posture* stand = model.findPosture("StandInit");
  return stand ? stand->angle : JointArray<double>(model.jointCount(), 0.0);
}

class ZmpGait final : public motion::Gait {
 public:
  ZmpGait(std::shared_ptr<const RobotModel> model, const Tuning& tuning);

  void walkTo(const Pose2& target, const GaitConfig& config) override;
  void walkToward(double x, double y, double theta, const GaitConfig& config) override;
  void walkAt(const Velocity2& velocity, const GaitConfig& config) override;
  void walkSteps(const std::vector<motion::StepOrder>& steps, bool clear) override;
  void setFeedback(const motion::WalkFeedback& feedback) override { feedback_ = feedback; }
  void stop() override;
  void kill() override;
  bool active() const override { return phase_ != Phase::Idle; }
  void update(const SensorFrame& measured, JointCommand& command) override;
  Pose2 position() const override { return position_; }
  Pose2 nextPosition() const override;
  Velocity2 velocity() const override;
  std::vector<motion::Footstep> footsteps() const override;
  std::unique_ptr<motion::Gait> clone() const override { return std::make_unique<ZmpGait>(*this); }
  void archive(Archive& archive) override;

 private:
  enum class Phase { Idle, Requested, Rising, Walking };

  void pursue(const Goal& goal);
  void begin(const JointCommand& command);
  void walk(const SensorFrame& measured, JointCommand& command);
  StanceDemand calcDemand() const;
  void pose(JointArray<double>& angle, bool resting);
  Eigen::Vector2d calcSwingAcceleration(std::int64_t tick) const;
  ComPlanner::Reaction reaction() const {
    return [this](std::int64_t tick) {
      return Eigen::Vector2d(tuning_.swing_reaction * calcSwingAcceleration(tick));
    };
  }
  void moveCom();
  Eigen::Vector2d calcDeviation(const SensorFrame& measured) const;
  void catchFall(const SensorFrame& measured);
  void limitSpeed(const JointArray<double>& last, JointArray<double>& angle) const;
  void swingArms(JointCommand& command);
  void balance(const SensorFrame& measured, JointArray<double>& angle);
  std::array<bool, 2> standing() const;
  std::array<bool, 2> carrying(const SensorFrame& measured) const;
  Pose2 placeOf(Foot foot) const;

  std::shared_ptr<const RobotModel> model_;
  Tuning tuning_;
  double dt_;  // [s] of a tick
  StanceSolver stance_;
  ServoLead servo_lead_;
  Balance balance_;
  Levelling levelling_;
  Sway sway_;
  double com_height_;  // [m]
  ComPlanner com_;
  FootstepPlan plan_;

  Phase phase_ = Phase::Idle;
  Goal goal_;
  motion::WalkFeedback feedback_;
  std::int64_t tick_ = 0;
  SimTime now_{};
  Rise rise_;
  Pose2 position_;
  std::array<std::optional<Joint>, 2> shoulder_;  // pitch, by side
  std::array<double, 2> shoulder_rest_{};         // [rad] where the swing is about
};

ZmpGait::ZmpGait(std::shared_ptr<const RobotModel> model, const Tuning& tuning)
    : model_(std::move(model)),
      tuning_(tuning),
      dt_(toSeconds(model_->cycle)),
      stance_(model_),
      servo_lead_(model_),
      balance_(*model_, tuning),
      levelling_(*model_, tuning),
      sway_(tuning),
      com_height_(
          stance_.calcComHeight(tuning.knee_bend, tuning.torso_pitch, standingAngles(*model_))),
      com_(*model_, tuning, dt_),
      plan_(tuning, dt_),
      shoulder_{model_->findJoint("LShoulderPitch"), model_->findJoint("RShoulderPitch")} {}

void ZmpGait::walkTo(const Pose2& target, const GaitConfig& config) {
  Goal goal;
  goal.kind = Goal::Kind::Target;
  goal.target = compose(nextPosition(), target);
  goal.config = config;
  pursue(goal);
}

void ZmpGait::walkToward(double x, double y, double theta, const GaitConfig& config) {
  Goal goal;
  goal.kind = Goal::Kind::Velocity;
  goal.fractions = {x, y, theta};
  goal.config = config;
  if (std::abs(x) + std::abs(y) + std::abs(theta) < 1e-6) return stop();
  pursue(goal);
}

void ZmpGait::walkAt(const Velocity2& velocity, const GaitConfig& config) {
  const StepFractions fractions = fractionsFor(velocity, config);
  walkToward(fractions.x, fractions.y, fractions.theta, config);
}

void ZmpGait::walkSteps(const std::vector<motion::StepOrder>& steps, bool clear) {
  if (phase_ == Phase::Walking) return plan_.order(steps, clear, tick_);
  const bool more = !clear && phase_ != Phase::Idle && goal_.kind == Goal::Kind::Steps;
  Goal goal;
  goal.kind = Goal::Kind::Steps;
  if (more) goal.steps = goal_.steps;
  goal.steps.insert(goal.steps.end(), steps.begin(), steps.end());
  pursue(goal);
}

void ZmpGait::stop() {
  if (phase_ == Phase::Idle || phase_ == Phase::Requested) return kill();
  Goal goal;
  goal.config = goal_.config;
  pursue(goal);
}

void ZmpGait::kill() { phase_ = Phase::Idle; }

void ZmpGait::pursue(const Goal& goal) {
  goal_ = goal;
  if (phase_ == Phase::Idle) phase_ = Phase::Requested;
  if (phase_ == Phase::Walking) plan_.follow(goal_, tick_);
}

void ZmpGait::update(const SensorFrame& measured, JointCommand& command) {
  now_ = measured.time;
  if (phase_ == Phase::Requested) begin(command);
  if (phase_ != Phase::Idle) walk(measured, command);
}

// The feet stay where the commanded angles have them; the legs will move into the pose that holds
// the centre of mass between them.
void ZmpGait::begin(const JointCommand& command) {
  const auto X_RS = stance_.calcSoles(command.angle);
  FeetPlaces feet;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 p = X_RS[i].translation();
    feet[i] = compose(position_, {p.x(), p.y(), rpyOf(X_RS[i].linear()).z()});
  }
  position_ = robotPlace(feet);
  plan_.reset(feet, tick_);
  com_height_ = stance_.calcComHeight(tuning_.knee_bend, tuning_.torso_pitch, command.angle);
  com_.reset(com_height_, plan_.calcZmp(tick_), tick_);
  JointArray<double> walking = command.angle;
  pose(walking, true);
  rise_.plan(*model_, command.angle, walking, dt_);
  for (std::size_t i = 0; i < 2; ++i) {
    if (shoulder_[i]) shoulder_rest_[i] = command.angle[*shoulder_[i]];
  }
  phase_ = Phase::Rising;
}

void ZmpGait::walk(const SensorFrame& measured, JointCommand& command) {
  ++tick_;
  plan_.setInset(feedback_.balance ? sway_.inset() : 0);
  if (phase_ == Phase::Rising && rise_.left() * dt_ <= kOverlap) {
    phase_ = Phase::Walking;
    plan_.follow(goal_, tick_);
  }
  plan_.advance(tick_, tick_ + com_.horizon());
  catchFall(measured);
  plan_.advance(tick_, tick_ + com_.horizon());
  moveCom();
  const JointArray<double> last = command.angle;
  swingArms(command);
  pose(command.angle, false);
  rise_.apply(command.angle);
  balance(measured, command.angle);
  limitSpeed(last, command.angle);
  position_ = robotPlace({placeOf(Foot::Left), placeOf(Foot::Right)});
  const bool calm = com_.velocity().norm() < kAtRest;
  if (plan_.atRest(tick_) && calm && rise_.left() == 0) phase_ = Phase::Idle;
}

// No command runs ahead of what the joint could follow.
void ZmpGait::limitSpeed(const JointArray<double>& last, JointArray<double>& angle) const {
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const Actuator& motor = model_->actuators[i];
    const double most = motor.max_velocity * dt_;
    if (most > 0) angle[i] = std::clamp(angle[i], last[i] - most, last[i] + most);
    angle[i] = std::clamp(angle[i], motor.lower, motor.upper);
  }
}

// Of the swinging sole along the floor [m/s^2].
Eigen::Vector2d ZmpGait::calcSwingAcceleration(std::int64_t tick) const {
  for (const PlannedStep& step : plan_.steps()) {
    if (tick >= step.end()) continue;
    if (tick < step.lift()) break;
    const double h = 1.0 / step.single_support;
    const double s = static_cast<double>(tick - step.lift()) * h;
    const double change = calcSwingPart(s + h, tuning_) - 2 * calcSwingPart(s, tuning_) +
                          calcSwingPart(s - h, tuning_);
    return change / (dt_ * dt_) * Eigen::Vector2d(step.to.x - step.from.x, step.to.y - step.from.y);
  }
  return Eigen::Vector2d::Zero();
}

// How far the capture point is from its plan [m], in O: the body turns about its sole as a pendulum
// of the height of the centre of mass. What every step sways is left out.
Eigen::Vector2d ZmpGait::calcDeviation(const SensorFrame& measured) const {
  const StanceDemand demand = calcDemand();
  const Eigen::Vector2d tilt(measured.angle_y - demand.pitch, demand.roll - measured.angle_x);
  const Eigen::Vector2d rate(measured.gyroscope.y(), -measured.gyroscope.x());
  const Eigen::Vector2d away = com_height_ * (tilt + rate * std::sqrt(com_height_ / kGravity));
  const double size = away.norm();
  if (size <= tuning_.usual_sway) return Eigen::Vector2d::Zero();
  const double heading = rpyOf(stance_.torso().linear()).z();
  return Eigen::Rotation2Dd(heading) * away * (1 - tuning_.usual_sway / size);
}

// A body that falls is caught where the swinging foot lands.
void ZmpGait::catchFall(const SensorFrame& measured) {
  const PlannedStep* step = plan_.current();
  if (!feedback_.steps || phase_ != Phase::Walking || !step ||
      !standing()[index(otherFoot(step->swing))])
    return;
  const double progress = static_cast<double>(tick_ - step->lift()) / step->single_support;
  if (progress < 0 || progress > kCommitted) return;
  const Eigen::Vector2d deviation = tuning_.step_gain * calcDeviation(measured);
  if (deviation.isZero() && step->moved.isZero()) return;
  const Pose2& support = plan_.feet()[index(otherFoot(step->swing))];
  const StepRoom room = calcStepRoom(relativeTo(support, step->to), step->swing);
  const Eigen::Vector2d forward(std::cos(support.theta), std::sin(support.theta));
  const Eigen::Vector2d by = com_.calcLanding(
      plan_, tick_, deviation, {step->moved, forward, room.low, room.high}, reaction());
  const double most = kCatchSpeed * dt_;
  plan_.moveLanding(by.norm() > most ? Eigen::Vector2d(by * most / by.norm()) : by);
}

void ZmpGait::moveCom() { com_.advance(plan_, tick_, reaction()); }

StanceDemand ZmpGait::calcDemand() const {
  StanceDemand demand;
  demand.com << com_.position(), com_height_;
  demand.roll = goal_.config.torso_wx;
  demand.pitch = tuning_.torso_pitch + goal_.config.torso_wy;
  for (std::size_t i = 0; i < 2; ++i) demand.X_OS[i] = onFloor(plan_.feet()[i]);
  const PlannedStep* step = plan_.current();
  if (step && tick_ > step->lift()) {
    const double progress = static_cast<double>(tick_ - step->lift()) / step->single_support;
    demand.X_OS[index(step->swing)] =
        calcSwing(step->from, step->to, progress, step->height, tuning_);
  }
  return demand;
}

// Leg commands for the present demand.
void ZmpGait::pose(JointArray<double>& angle, bool resting) {
  stance_.solve(calcDemand(), angle);
  servo_lead_.plan(angle, stance_.body(), stance_.torso(), standing(), resting);
  servo_lead_.apply(angle);
}

// What the sensors say of the body, into the ankles.
void ZmpGait::balance(const SensorFrame& measured, JointArray<double>& angle) {
  if (!feedback_.balance) return;
  const StanceDemand demand = calcDemand();
  levelling_.learn(measured.angle_y - demand.pitch, standing(), dt_);
  sway_.watch(measured.angle_x - demand.roll, standing());
  levelling_.apply(angle);
  balance_.apply(measured.gyroscope, carrying(measured), angle);
}

std::array<bool, 2> ZmpGait::standing() const {
  std::array<bool, 2> stands{true, true};
  const PlannedStep* step = plan_.current();
  if (step && tick_ > step->lift()) stands[index(step->swing)] = false;
  return stands;
}

// Feet that stand by the plan, and those that the force sensors say have landed early.
std::array<bool, 2> ZmpGait::carrying(const SensorFrame& measured) const {
  std::array<bool, 2> carries = standing();
  for (std::size_t i = 0; i < 2; ++i) {
    carries[i] = carries[i] || measured.feet[i].total > kTouch;
  }
  return carries;
}

// The sole's place on the floor now, swinging or not.
Pose2 ZmpGait::placeOf(Foot foot) const {
  const Pose X_OS = calcDemand().X_OS[index(foot)];
  return {X_OS.translation().x(), X_OS.translation().y(), rpyOf(X_OS.linear()).z()};
}

// Each arm swings with the opposite foot.
void ZmpGait::swingArms(JointCommand& command) {
  const Pose2 ahead = relativeTo(placeOf(Foot::Right), placeOf(Foot::Left));
  for (std::size_t i = 0; i < 2; ++i) {
    if (!shoulder_[i]) continue;
    const double side = i == 0 ? 1 : -1;
    command.angle[*shoulder_[i]] = shoulder_rest_[i] + side * tuning_.arm_swing * ahead.x;
  }
}

Pose2 ZmpGait::nextPosition() const {
  return phase_ == Phase::Walking ? robotPlace(plan_.nextFeet()) : position_;
}

Velocity2 ZmpGait::velocity() const {
  const PlannedStep* step = phase_ == Phase::Walking ? plan_.current() : nullptr;
  if (!step) return {};
  const Pose2 way = relativeTo(robotPlace(plan_.feet()), robotPlace(plan_.nextFeet()));
  const double period = static_cast<double>(step->end() - step->start) * dt_;
  return {way.x / period, way.y / period, way.theta / period};
}

std::vector<motion::Footstep> ZmpGait::footsteps() const {
  std::vector<motion::Footstep> steps;
  if (phase_ != Phase::Walking) return steps;
  for (const PlannedStep& step : plan_.steps()) {
    const Duration until = (step.end() - tick_) * model_->cycle;
    steps.push_back({step.swing, step.to, now_ + until});
  }
  return steps;
}

void ZmpGait::archive(Archive& archive) {
  stance_.archive(archive);
  servo_lead_.archive(archive);
  levelling_.archive(archive);
  sway_.archive(archive);
  archive.value(com_height_);
  plan_.archive(archive);
  archive.value(phase_);
  goal_.archive(archive);
  archive.value(feedback_.balance);
  archive.value(feedback_.steps);
  archive.value(tick_);
  archive.value(now_);
  rise_.archive(archive);
  com_.archive(archive);
  archive.value(position_);
  archive.value(shoulder_rest_);
}

}  // namespace

std::unique_ptr<motion::Gait> makeZmpGait(std::shared_ptr<const RobotModel> model,
                                          const Tuning& tuning) {
  if (!motion::LegIk::fits(*model)) return nullptr;
  return std::make_unique<ZmpGait>(std::move(model), tuning);
}

}  // namespace nao::walk
