#include "walk_engine/step_rules.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nao::walk {
namespace {

using Eigen::Vector2d;
using motion::GaitConfig;

constexpr double kMinStepPeriod = 0.42;  // [s]
constexpr double kMaxStepPeriod = 0.60;  // [s]

// The box ALMotion draws round a left foot, in the sole's frame [m]; a right one is its mirror.
// As published it lets full turning reach 39.4 degrees/s; the thesis measured 42 on the robot,
// which boxes drawn in by this much give. Fitted to that one figure.
constexpr double kBoxInset = 0.00164;
constexpr double kBoxFront = 0.11 - kBoxInset;
constexpr double kBoxRear = -0.047 + kBoxInset;
constexpr double kBoxOuter = 0.05 - kBoxInset;
constexpr double kBoxInner = -0.038 + kBoxInset;

std::array<Vector2d, 4> footBox(const Pose2& place, Foot foot) {
  const double side = sideOf(foot);
  const std::array<Vector2d, 4> corners = {
      Vector2d{kBoxFront, kBoxOuter}, Vector2d{kBoxFront, kBoxInner}, Vector2d{kBoxRear, kBoxInner},
      Vector2d{kBoxRear, kBoxOuter}};
  std::array<Vector2d, 4> box;
  for (std::size_t i = 0; i < 4; ++i) {
    const Pose2 corner = compose(place, {corners[i].x(), side * corners[i].y(), 0});
    box[i] = {corner.x, corner.y};
  }
  return box;
}

// Whether a line parallel to an edge of `a` separates the boxes.
bool separates(const std::array<Vector2d, 4>& a, const std::array<Vector2d, 4>& b) {
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector2d direction = a[i + 1] - a[i];
    double a_low = 1e9, a_high = -1e9, b_low = 1e9, b_high = -1e9;
    for (std::size_t k = 0; k < 4; ++k) {
      a_low = std::min(a_low, direction.dot(a[k]));
      a_high = std::max(a_high, direction.dot(a[k]));
      b_low = std::min(b_low, direction.dot(b[k]));
      b_high = std::max(b_high, direction.dot(b[k]));
    }
    if (a_high < b_low || b_high < a_low) return true;
  }
  return false;
}

// The largest turn towards `theta` at which the boxes do not meet.
double clipTurn(Pose2 step, Foot swing) {
  if (!feetCollide(step, swing)) return step.theta;
  double clear = 0;
  double meeting = step.theta;
  for (int i = 0; i < 40; ++i) {
    step.theta = 0.5 * (clear + meeting);
    (feetCollide(step, swing) ? meeting : clear) = step.theta;
  }
  return clear;
}

// The limits of ALMotion's MaxStepX, MinStepX and MaxStepY (NAOqi 1.14 and 2.1, control-walk).
constexpr double kLongestStep = 0.08;  // [m]
constexpr double kWidestStep = 0.16;   // [m]
constexpr double kParallel = 0.1;      // [rad] free: feet turned less than that count as parallel

double clipFraction(double fraction) { return std::clamp(fraction, -1.0, 1.0); }

// The motion that, kept up in the moving frame, ends at `target` after a time of 1.
motion::Velocity2 arcTo(const Pose2& target) {
  const double half = 0.5 * target.theta;
  const double scale = std::abs(half) < 1e-9 ? 1 : half / std::tan(half);
  return {scale * target.x + half * target.y, -half * target.x + scale * target.y, target.theta};
}

double ratio(double part, double whole) { return whole == 0 ? 0 : part / std::abs(whole); }

}  // namespace

Pose2 soleAt(const Pose2& place, Foot foot) {
  return compose(place, {0, sideOf(foot) * kFootSeparation / 2, 0});
}

double calcStepPeriod(const GaitConfig& config) {
  const double frequency = std::clamp(config.max_step_frequency, 0.0, 1.0);
  return kMaxStepPeriod + frequency * (kMinStepPeriod - kMaxStepPeriod);
}

bool feetCollide(const Pose2& step, Foot swing) {
  const auto moving = footBox(step, swing);
  const auto standing = footBox({}, otherFoot(swing));
  return !separates(moving, standing) && !separates(standing, moving);
}

Pose2 clipStep(const Pose2& step, Foot swing, const GaitConfig& config) {
  const double side = sideOf(swing);
  double x = std::clamp(step.x, config.min_step_x, config.max_step_x);
  double apart = std::clamp(side * step.y, kMinFootSeparation, config.max_step_y);
  const double theta = std::clamp(step.theta, -config.max_step_theta, config.max_step_theta);
  const double beyond = std::max(0.0, apart - kFootSeparation);
  const double along = ratio(x, x < 0 ? config.min_step_x : config.max_step_x);
  const double across = ratio(beyond, config.max_step_y - kFootSeparation);
  const double radius = std::hypot(along, across);
  if (radius > 1) {
    x /= radius;
    if (beyond > 0) apart = kFootSeparation + beyond / radius;
  }
  Pose2 clipped{x, side * apart, theta};
  clipped.theta = clipTurn(clipped, swing);
  return clipped;
}

Pose2 calcStep(const StepFractions& fractions, Foot swing, const GaitConfig& config) {
  const double fx = clipFraction(fractions.x);
  const double reach_x = fx < 0 ? -config.min_step_x : config.max_step_x;
  const double y = sideOf(swing) * kFootSeparation +
                   clipFraction(fractions.y) * (config.max_step_y - kFootSeparation);
  const double theta = clipFraction(fractions.theta) * config.max_step_theta;
  return clipStep({fx * reach_x, y, theta}, swing, config);
}

StepRoom calcStepRoom(const Pose2& step, Foot swing) {
  const double side = sideOf(swing);
  // Turned feet come nearer to each other than their middles tell.
  const double inward = std::abs(step.theta) > kParallel ? 0 : kMinFootSeparation - side * step.y;
  const double outward = kWidestStep - side * step.y;
  StepRoom room;
  room.low = {-kLongestStep - step.x, side > 0 ? inward : -outward};
  room.high = {kLongestStep - step.x, side > 0 ? outward : -inward};
  room.low = room.low.cwiseMin(0);
  room.high = room.high.cwiseMax(0);
  return room;
}

// How far R gets in a pair of steps.
Pose2 calcPair(const StepFractions& fractions, const GaitConfig& config) {
  const Pose2 left = calcStep(fractions, Foot::Left, config);
  const Pose2 right = calcStep(fractions, Foot::Right, config);
  return {left.x + right.x, left.y + right.y, left.theta + right.theta};
}

Pose2 calcPairReach(const StepFractions& signs, const GaitConfig& config) {
  const auto full = [](double value) { return value < 0 ? -1.0 : 1.0; };
  return {std::abs(calcPair({full(signs.x), 0, 0}, config).x),
          std::abs(calcPair({0, full(signs.y), 0}, config).y),
          std::abs(calcPair({0, 0, full(signs.theta)}, config).theta)};
}

// Short steps are not clipped, long ones are: the fraction has to be looked for.
StepFractions fractionsFor(const motion::Velocity2& velocity, const GaitConfig& config) {
  const double pair = 2 * calcStepPeriod(config);
  const auto find = [&](double wanted, const std::function<double(double)>& gained) {
    double low = 0, high = 1;
    if (gained(high) <= wanted) return high;
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (gained(middle) < wanted ? low : high) = middle;
    }
    return high;
  };
  const auto alone = [&](double wanted, StepFractions one, double Pose2::*part) {
    if (wanted == 0) return 0.0;
    const double sign = wanted < 0 ? -1 : 1;
    return sign * find(std::abs(wanted) * pair, [&](double f) {
             const double g = sign * f;
             return std::abs(calcPair({g * one.x, g * one.y, g * one.theta}, config).*part);
           });
  };
  return {alone(velocity.x, {1, 0, 0}, &Pose2::x), alone(velocity.y, {0, 1, 0}, &Pose2::y),
          alone(velocity.theta, {0, 0, 1}, &Pose2::theta)};
}

StepFractions fractionsTowards(const Pose2& target, const GaitConfig& config) {
  const motion::Velocity2 arc = arcTo(target);
  const Pose2 reach = calcPairReach({arc.x, arc.y, arc.theta}, config);
  const double x = ratio(arc.x, reach.x);
  const double y = ratio(arc.y, reach.y);
  const double theta = ratio(arc.theta, reach.theta);
  const double pairs = std::max(
      {std::abs(x), std::abs(y), std::abs(theta), std::hypot(x, y), 1e-9});  // of steps to go
  return {x / pairs, y / pairs, theta / pairs};
}

}  // namespace nao::walk
