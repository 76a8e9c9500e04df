#include "walk_engine/footstep_plan.h"

#include <algorithm>
#include <cmath>

namespace nao::walk {
namespace {

using Eigen::Vector2d;
using motion::GaitConfig;
using motion::StepOrder;

constexpr double kNotice = 0.4;      // [s] e^(-6.1 * 0.4): a tenth of the change is felt now
constexpr double kSamePlace = 1e-6;  // [m], [rad] below anything a command can resolve
// [m], [rad] A robot that sways has each landing moved a little; steps that only undo that sway it
// on and never end. Free: a twentieth of a sole's width.
constexpr double kCloseEnough = 0.005;
// Steps to where the goal wants that foot: one each, and one each that mends the landing. Free.
constexpr int kMostArrivals = 4;

bool same(const Pose2& a, const Pose2& b, double tolerance = kSamePlace) {
  return std::hypot(a.x - b.x, a.y - b.y) < tolerance &&
         std::abs(wrapAngle(a.theta - b.theta)) < tolerance;
}

// Where R would be if the other foot stood beside this one.
Pose2 placeBeside(const Pose2& sole, Foot foot) {
  return compose(sole, {0, -sideOf(foot) * kFootSeparation / 2, 0});
}

// Beside the supporting foot; nothing if the swinging one already stands there, or nearly.
std::optional<Pose2> closeFeet(const FeetPlaces& feet, Foot swing) {
  const Foot support = otherFoot(swing);
  const Pose2 beside = soleAt(placeBeside(feet[index(support)], support), swing);
  if (same(beside, feet[index(swing)], kCloseEnough)) return std::nullopt;
  return beside;
}

std::optional<Pose2> stepTowards(const Goal& goal, const FeetPlaces& feet, Foot swing) {
  const Pose2& support = feet[index(otherFoot(swing))];
  const Pose2 wanted = soleAt(goal.target, swing);
  if (same(wanted, feet[index(swing)]) && same(soleAt(goal.target, otherFoot(swing)), support)) {
    return std::nullopt;
  }
  const Pose2 direct = relativeTo(support, wanted);
  if (same(direct, clipStep(direct, swing, goal.config))) return wanted;
  const Pose2 base = placeBeside(support, otherFoot(swing));
  const StepFractions fractions = fractionsTowards(relativeTo(base, goal.target), goal.config);
  return compose(support, calcStep(fractions, swing, goal.config));
}

constexpr double kShortestStep = 0.42;  // [s] MinStepPeriod of control-walk

// What the legs can reach at most: ordered steps are clipped to the largest gait, not the default.
GaitConfig widestGait() {
  GaitConfig gait;
  gait.max_step_x = 0.08;  // gait_config.csv, the maxima of control-walk 1.14 and 2.1
  gait.max_step_y = 0.16;
  gait.max_step_theta = 0.524;
  return gait;
}

// Whether it takes its foot to where the goal wants it.
bool arrives(const Goal& goal, const PlannedStep& step) {
  return goal.kind == Goal::Kind::Stand ||
         (goal.kind == Goal::Kind::Target && same(step.to, soleAt(goal.target, step.swing)));
}

double smooth(double s) { return s * s * (3 - 2 * s); }

}  // namespace

void Goal::archive(Archive& archive) {
  archive.value(kind);
  archive.value(fractions);
  archive.value(target);
  archive.each(steps, [&archive](StepOrder& step) {
    archive.value(step.foot);
    archive.value(step.place);
    archive.value(step.period);
  });
  motion::archiveConfig(archive, config);
}

void PlannedStep::archive(Archive& archive) {
  archive.value(swing);
  archive.value(from);
  archive.value(to);
  archive.value(start);
  archive.value(arrives);
  for (int* ticks : {&double_support, &single_support, &shift}) archive.value(*ticks);
  archive.value(height);
  archive.numbers(zmp_from);
  archive.numbers(zmp_to);
  archive.numbers(moved);
}

Pose2 robotPlace(const FeetPlaces& feet) {
  const double turn = wrapAngle(feet[1].theta - feet[0].theta);
  return {0.5 * (feet[0].x + feet[1].x), 0.5 * (feet[0].y + feet[1].y),
          wrapAngle(feet[0].theta + 0.5 * turn)};
}

std::optional<Pose2> calcNextPlace(const Goal& goal, const FeetPlaces& feet, Foot swing) {
  switch (goal.kind) {
    case Goal::Kind::Stand:
      return closeFeet(feet, swing);
    case Goal::Kind::Velocity:
      return compose(feet[index(otherFoot(swing))], calcStep(goal.fractions, swing, goal.config));
    case Goal::Kind::Target:
      return stepTowards(goal, feet, swing);
    case Goal::Kind::Steps:
      return std::nullopt;
  }
  return std::nullopt;
}

Foot chooseFirstFoot(const Goal& goal, const FeetPlaces& feet) {
  StepFractions way = goal.fractions;
  if (goal.kind == Goal::Kind::Target) {
    way = fractionsTowards(relativeTo(robotPlace(feet), goal.target), goal.config);
  }
  const double left = way.y + way.theta;
  return left < -1e-9 ? Foot::Right : Foot::Left;
}

FootstepPlan::FootstepPlan(const Tuning& tuning, double tick_seconds)
    : tuning_(tuning), tick_seconds_(tick_seconds) {
  steps_.reserve(32);
}

int FootstepPlan::ticks(double seconds) const {
  return std::max(1, static_cast<int>(std::lround(seconds / tick_seconds_)));
}

Vector2d FootstepPlan::zmpOf(const Pose2& sole, Foot foot) const {
  const Pose2 point = compose(sole, {tuning_.zmp_x, sideOf(foot) * (tuning_.zmp_y - inset_), 0});
  return {point.x, point.y};
}

Vector2d FootstepPlan::zmpBetween(const FeetPlaces& feet) const {
  return 0.5 * (zmpOf(feet[0], Foot::Left) + zmpOf(feet[1], Foot::Right));
}

void FootstepPlan::reset(const FeetPlaces& feet, std::int64_t now) {
  feet_ = feet;
  steps_.clear();
  goal_ = Goal();
  complete_ = true;
  arrivals_ = 0;
  stand_zmp_ = zmpBetween(feet_);
  stand_since_ = now - ticks(tuning_.end_double_support);
}

void FootstepPlan::follow(const Goal& goal, std::int64_t now) {
  advance(now, now);
  // A body that is coming to rest is past the point where it could go on to the other foot.
  const bool resting = complete_ || rest_first_ || steps_.empty() ||
                       (steps_.size() > 1 && steps_[1].shift < steps_[1].double_support);
  rest_first_ = resting && (steps_.empty() || steps_.front().end() - now < ticks(kNotice));
  goal_ = goal;
  complete_ = false;
  arrivals_ = 0;
  begin_ = now;
  if (steps_.size() > 1) steps_.erase(steps_.begin() + 1, steps_.end());
}

FeetPlaces FootstepPlan::lastFeet() const {
  FeetPlaces feet = feet_;
  for (const PlannedStep& step : steps_) feet[index(step.swing)] = step.to;
  return feet;
}

FeetPlaces FootstepPlan::nextFeet() const {
  FeetPlaces feet = feet_;
  if (!steps_.empty()) feet[index(steps_.front().swing)] = steps_.front().to;
  return feet;
}

std::int64_t FootstepPlan::end() const {
  return steps_.empty() ? stand_since_ : steps_.back().end();
}

void FootstepPlan::order(const std::vector<StepOrder>& steps, bool clear, std::int64_t now) {
  advance(now, now);
  Goal goal;
  goal.kind = Goal::Kind::Steps;
  if (!clear && goal_.kind == Goal::Kind::Steps) goal.steps = withdrawOrders();
  goal.steps.insert(goal.steps.end(), steps.begin(), steps.end());
  follow(goal, now);
}

// The ordered steps that may still change, planned or not.
std::vector<StepOrder> FootstepPlan::withdrawOrders() const {
  std::vector<StepOrder> orders;
  FeetPlaces feet = nextFeet();
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    const PlannedStep& step = steps_[i];
    const Pose2 place = relativeTo(feet[index(otherFoot(step.swing))], step.to);
    orders.push_back(
        {step.swing, place, static_cast<double>(step.end() - step.start) * tick_seconds_});
    feet[index(step.swing)] = step.to;
  }
  orders.insert(orders.end(), goal_.steps.begin(), goal_.steps.end());
  return orders;
}

bool FootstepPlan::hasArrived() const {
  const auto planned = std::count_if(steps_.begin(), steps_.end(),
                                     [](const PlannedStep& step) { return step.arrives; });
  return arrivals_ + planned >= kMostArrivals;
}

// What the goal asks for at the end of the plan.
std::optional<FootstepPlan::NextStep> FootstepPlan::chooseNext(const FeetPlaces& feet) {
  if (goal_.kind == Goal::Kind::Steps) {
    if (goal_.steps.empty()) return std::nullopt;
    const StepOrder next = goal_.steps.front();
    goal_.steps.erase(goal_.steps.begin());
    const Pose2& support = feet[index(otherFoot(next.foot))];
    return NextStep{next.foot, compose(support, clipStep(next.place, next.foot, widestGait())),
                    std::max(next.period, kShortestStep)};
  }
  if (hasArrived()) return std::nullopt;
  const Foot swing = steps_.empty() ? chooseFirstFoot(goal_, feet) : otherFoot(steps_.back().swing);
  FeetPlaces base = feet;
  // Before the first step the feet may be splayed: the way ahead is R's, not the support's.
  if (steps_.empty()) base[index(otherFoot(swing))].theta = robotPlace(feet).theta;
  const std::optional<Pose2> place = calcNextPlace(goal_, base, swing);
  if (!place) return std::nullopt;
  return NextStep{swing, *place, calcStepPeriod(goal_.config)};
}

// One more step at the end of the plan; false if the goal asks for none.
bool FootstepPlan::append() {
  const FeetPlaces feet = lastFeet();
  const std::optional<NextStep> next = chooseNext(feet);
  if (!next) return false;
  const Foot swing = next->swing;
  const Foot support = otherFoot(swing);
  const int period = ticks(next->period);
  PlannedStep step;
  step.swing = swing;
  step.from = feet[index(swing)];
  step.to = next->to;
  step.start = steps_.empty() ? begin_ : end();
  step.double_support = ticks(tuning_.double_support_share * period * tick_seconds_);
  step.shift = step.double_support;
  const double way = std::hypot(step.to.x - step.from.x, step.to.y - step.from.y);  // [m]
  step.height = goal_.config.step_height;
  step.single_support = std::max({period - step.double_support, ticks(way / tuning_.swing_speed),
                                  ticks(step.height / tuning_.lift_speed)});
  step.arrives = arrives(goal_, step);
  step.zmp_from = steps_.empty() ? Vector2d::Zero() : steps_.back().zmp_to;
  step.zmp_to = zmpOf(feet[index(support)], support);
  if (rest_first_) {
    step.double_support = ticks(tuning_.start_double_support);
    step.zmp_from = zmpBetween(feet);
    rest_first_ = false;
  }
  steps_.push_back(step);
  return true;
}

void FootstepPlan::moveLanding(const Vector2d& by) {
  if (steps_.empty()) return;
  PlannedStep& step = steps_.front();
  step.to.x += by.x();
  step.to.y += by.y();
  step.moved += by;
  steps_.erase(steps_.begin() + 1, steps_.end());
  complete_ = false;
}

void FootstepPlan::setInset(double inset) {
  if (inset == inset_) return;
  inset_ = inset;
  FeetPlaces feet = nextFeet();
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    PlannedStep& step = steps_[i];
    const Foot support = otherFoot(step.swing);
    const bool rests = step.shift < step.double_support;  // between both feet
    if (!rests) step.zmp_from = steps_[i - 1].zmp_to;
    step.zmp_to = zmpOf(feet[index(support)], support);
    feet[index(step.swing)] = step.to;
  }
}

void FootstepPlan::advance(std::int64_t now, std::int64_t horizon) {
  while (!complete_ && end() <= horizon) complete_ = !append();
  while (!steps_.empty() && steps_.front().end() <= now) {
    const PlannedStep& done = steps_.front();
    feet_[index(done.swing)] = done.to;
    arrivals_ += done.arrives ? 1 : 0;
    stand_since_ = done.end();
    stand_zmp_ = done.zmp_to;
    steps_.erase(steps_.begin());
  }
}

Vector2d FootstepPlan::calcZmp(std::int64_t tick) const {
  std::int64_t since = stand_since_;
  Vector2d from = stand_zmp_;
  for (const PlannedStep& step : steps_) {
    if (tick < step.end()) {
      const std::int64_t moving = tick - step.lift() + step.shift;  // [ticks] into the shift
      if (moving < 0) return settle(from, step.zmp_from, tick - since);
      const double s = std::min(1.0, static_cast<double>(moving) / step.shift);
      return step.zmp_from + s * (step.zmp_to - step.zmp_from);
    }
    since = step.end();
    from = step.zmp_to;
  }
  return settle(from, zmpBetween(lastFeet()), tick - since);
}

// On the way from one foot to rest between both.
Vector2d FootstepPlan::settle(const Vector2d& from, const Vector2d& rest,
                              std::int64_t elapsed) const {
  const double s = static_cast<double>(elapsed) / (0.5 * ticks(tuning_.end_double_support));
  return from + smooth(std::clamp(s, 0.0, 1.0)) * (rest - from);
}

bool FootstepPlan::atRest(std::int64_t now) const {
  return steps_.empty() && complete_ && now >= stand_since_ + ticks(tuning_.end_double_support);
}

void FootstepPlan::archive(Archive& archive) {
  goal_.archive(archive);
  archive.value(feet_);
  archive.each(steps_, [&archive](PlannedStep& step) { step.archive(archive); });
  archive.value(inset_);
  archive.value(complete_);
  archive.value(arrivals_);
  archive.value(rest_first_);
  archive.value(begin_);
  archive.value(stand_since_);
  archive.numbers(stand_zmp_);
}

}  // namespace nao::walk
