#include "walk_engine/com_planner.h"

#include <algorithm>
#include <cmath>

namespace nao::walk {
namespace {

using Eigen::Vector2d;

constexpr double kGravity = 9.80665;    // [m/s^2]
constexpr double kUsualHeight = 0.26;   // [m] until the first reset
constexpr double kMotionTick = 0.02;    // [s] ALMotion's, V3 to V5
constexpr double kForget = 0.7;         // [s] e^(-6.1 * 0.7): 1.4 % of what comes later
constexpr double kEverySample = 0.025;  // [s] of the reference after the preview

struct Stretch {
  int instants;
  double seconds;
};
// Fine where the solution is used, coarse where it only has to be possible: 1.1 s in all.
constexpr Stretch kPreview[] = {{5, kMotionTick}, {4, 0.05}, {8, 0.1}};

int ticksOf(double seconds, double dt) {
  return std::max(1, static_cast<int>(std::floor(seconds / dt + 1e-9)));
}

}  // namespace

ComPlanner::ComPlanner(const RobotModel& model, const Tuning& tuning, double tick_seconds)
    : support_(model, tuning.support_margin),
      dt_(tick_seconds),
      lead_(static_cast<int>(std::lround(tuning.zmp_lead / tick_seconds))),
      height_(kUsualHeight),
      qp_(kUsualHeight, kGravity),
      landing_qp_(kUsualHeight, kGravity) {
  for (const Stretch& stretch : kPreview) {
    for (int i = 0; i < stretch.instants; ++i) ticks_.push_back(ticksOf(stretch.seconds, dt_));
  }
  after_ = ticksOf(kForget, dt_);
  horizon_ = after_;
  for (const int ticks : ticks_) horizon_ += ticks;
  samples_.resize(ticks_.size());
}

void ComPlanner::reset(double com_height, const Vector2d& place, std::int64_t now) {
  setHeight(com_height);
  com_ = {Eigen::Vector3d(place.x(), 0, 0), Eigen::Vector3d(place.y(), 0, 0)};
  jerk_.setZero();
  solved_ = now - ticks_.front();
}

void ComPlanner::setHeight(double com_height) {
  height_ = com_height;
  qp_ = ZmpQp(com_height, kGravity);
  landing_qp_ = qp_;
}

void ComPlanner::advance(const FootstepPlan& plan, std::int64_t now, const Reaction& reaction) {
  if (now - solved_ >= ticks_.front()) {
    preview(plan, now - 1, reaction, 0);
    jerk_ = qp_.solve(com_, samples_, end_, {}).jerk;
    solved_ = now;
  }
  com_ = ZmpQp::carryOn(com_, jerk_, dt_);
}

// What the plan asks for at the instants after `now`.
void ComPlanner::preview(const FootstepPlan& plan, std::int64_t now, const Reaction& reaction,
                         int movable) {
  std::int64_t from = now;
  for (std::size_t k = 0; k < ticks_.size(); ++k) {
    const std::int64_t to = from + ticks_[k];
    ZmpSample& sample = samples_[k];
    const Vector2d driven = reaction(to);
    const Support::Feet feet = Support::feetAt(plan, to);
    sample.dt = ticks_[k] * dt_;
    sample.reference = calcReference(plan, to + lead_, ticks_[k]) - driven;
    sample.support = support_.edges(feet, movable);
    for (SupportEdge& edge : sample.support) edge.offset -= edge.normal.dot(driven);
    sample.step = std::min(std::max(feet.landing[0], feet.landing[1]), movable - 1);
    sample.share = sample.step < 0 ? 0 : feet.stands[0] && feet.stands[1] ? 0.5 : 1;
    from = to;
  }
  end_ = calcEnd(plan, from, movable);
}

// Its mean over `width` ticks about `tick`: a sample stands for all of its surroundings.
Vector2d ComPlanner::calcReference(const FootstepPlan& plan, std::int64_t tick, int width) const {
  Vector2d sum = Vector2d::Zero();
  for (int i = 0; i < width; ++i) sum += plan.calcZmp(tick - width / 2 + i);
  return sum / width;
}

// The capture point from which the reference after `tick` can be followed for ever is
//   xi = rate * integral of e^(-rate s) z(tick + s) ds.
// It may be as far away as the next step can catch it.
CaptureGoal ComPlanner::calcEnd(const FootstepPlan& plan, std::int64_t tick, int movable) const {
  CaptureGoal end;
  const int stride = ticksOf(kEverySample, dt_);
  const double decay = std::exp(-qp_.rate() * stride * dt_);
  double weight = 1 - decay;
  double left = 1;
  for (int j = 0; j + stride <= after_; j += stride, weight *= decay) {
    end.reference += weight * plan.calcZmp(tick + j + stride / 2);
    left -= weight;
  }
  end.reference += left * plan.calcZmp(tick + after_);
  Support::Feet feet = Support::feetAt(plan, tick);
  for (const PlannedStep& step : plan.steps()) {
    if (tick >= step.end()) continue;
    feet.places[index(step.swing)] = step.to;
    break;
  }
  feet.stands = {true, true};
  end.support = support_.edges(feet, movable);
  end.step = movable - 1;
  return end;
}

Vector2d ComPlanner::calcLanding(const FootstepPlan& plan, std::int64_t now,
                                 const Vector2d& deviation, const LandingRange& range,
                                 const Reaction& reaction) {
  preview(plan, now, reaction, 1);
  ComState pushed = com_;
  pushed.x[1] += landing_qp_.rate() * deviation.x();
  pushed.y[1] += landing_qp_.rate() * deviation.y();
  return landing_qp_.solve(pushed, samples_, end_, {range}).moved[0];
}

void ComPlanner::push(const Vector2d& velocity) {
  com_.x[1] += velocity.x();
  com_.y[1] += velocity.y();
}

void ComPlanner::archive(Archive& archive) {
  archive.value(height_);
  if (archive.mode() == Archive::Mode::Load) setHeight(height_);
  qp_.archive(archive);
  landing_qp_.archive(archive);
  com_.archive(archive);
  archive.numbers(jerk_);
  archive.value(solved_);
}

}  // namespace nao::walk
