#include "sim/sonar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shape_distance.h"

namespace nao::sim {
namespace {

constexpr int kRimRays = 9;          // along the part of a cone's rim that a thing may cut
constexpr int kRefinings = 9;        // of the best of them: each takes 0.62 of the angle left
constexpr int kSphereSteps = 64;     // free: enough for a ray that grazes a thing
constexpr double kOnSurface = 5e-4;  // [m]
constexpr double kReach = 0.7;       // [m] no part of a robot is farther from its torso

// Along a ray from the apex, by steps as long as nothing is near (sphere tracing). Where it hits,
// or else more than `farthest`, by how far it passes.
double trace(const Vec3& p, const Vec3& way, double farthest, const Shape& shape) {
  double along = 0;
  double closest = farthest;
  for (int k = 0; k < kSphereSteps && along < farthest; ++k) {
    const double free = calcSurfacePoint(shape, p + along * way).distance;
    if (free < kOnSurface) return along;
    closest = std::min(closest, free);
    along += free;
  }
  return farthest + closest;
}

// Whether a sphere about `center`, seen from the apex, reaches into the cone.
bool mayBeInCone(const Vec3& center, double radius, const Vec3& axis, double half_angle) {
  const double distance = center.norm();
  if (distance <= radius) return true;
  const double off_axis = std::acos(std::clamp(center.dot(axis) / distance, -1.0, 1.0));
  return off_axis - std::asin(radius / distance) <= half_angle;
}

// Where the nearest point of a convex thing lies outside a cone, the nearest one inside lies on the
// cone's rim: distance is convex. It is sought on the part of the rim that the thing may cut.
class Rim {
 public:
  Rim(const Shape& shape, const Vec3& p, const Vec3& axis, double half_angle, double farthest)
      : shape_(shape), p_(p), farthest_(farthest) {
    const Vec3 across = -p - axis * axis.dot(-p);  // from the axis to the thing
    const double off = across.norm();
    const Vec3 side = off > 1e-9 ? Vec3(across / off) : axis.unitOrthogonal();
    along_ = std::cos(half_angle) * axis;
    towards_ = std::sin(half_angle) * side;
    sideways_ = std::sin(half_angle) * axis.cross(side);
    const double radius = boundingRadius(shape);
    half_width_ = radius < off ? std::asin(radius / off) : M_PI;
  }

  double nearest() const {
    const double step = 2 * half_width_ / (kRimRays - 1);
    double best = 0;
    double found = std::numeric_limits<double>::max();
    for (int k = 0; k < kRimRays; ++k) {
      const double turn = k * step - half_width_;
      const double distance = at(turn);
      if (distance >= found) continue;
      found = distance;
      best = turn;
    }
    return refine(best - step, best + step, found);
  }

 private:
  double at(double turn) const {
    const Vec3 way = along_ + std::cos(turn) * towards_ + std::sin(turn) * sideways_;
    return trace(p_, way, farthest_, shape_);
  }

  // Golden section search.
  double refine(double low, double high, double found) const {
    constexpr double kGolden = 0.6180339887498949;
    double a = high - kGolden * (high - low);
    double b = low + kGolden * (high - low);
    double at_a = at(a);
    double at_b = at(b);
    for (int k = 0; k < kRefinings; ++k) {
      if (at_a < at_b) {
        high = b;
        b = a;
        at_b = at_a;
        at_a = at(a = high - kGolden * (high - low));
      } else {
        low = a;
        a = b;
        at_a = at_b;
        at_b = at(b = low + kGolden * (high - low));
      }
    }
    return std::min({found, at_a, at_b});
  }

  const Shape& shape_;
  Vec3 p_;
  double farthest_;
  Vec3 along_, towards_, sideways_;  // of the rays
  double half_width_;                // [rad] about the axis
};

Pose poseOf(const BodyMotion& body) {
  Pose X = Pose::Identity();
  X.linear() = body.R_WB;
  X.translation() = body.p_WB;
  return X;
}

class Listener {
 public:
  Listener(const SonarModel& sonar, const Pose& X_WR) : sonar_(sonar), X_WR_(X_WR) {}

  const Vec3 place() const { return X_WR_.translation(); }
  double range() const { return sonar_.max_range; }
  bool mayHear(const Vec3& p_W, double radius) const {
    const Vec3 away = p_W - place();
    return away.norm() < range() + radius &&
           mayBeInCone(away, radius, X_WR_.linear().col(0), sonar_.half_cone);
  }

  void hear(const Shape& shape, const Pose& X_WS) { hear(&shape, X_WS); }

  // Things in one body are heard as one.
  void hear(const std::vector<Shape>& shapes, const Pose& X_WB) {
    std::optional<double> nearest;
    for (const Shape& shape : shapes) {
      const auto distance = calcDistanceInCone(X_WR_, sonar_.half_cone, nearest.value_or(range()),
                                               shape, X_WB * shape.X_BS);
      if (distance) nearest = distance;
    }
    if (nearest) heard_.push_back(*nearest);
  }

  SonarEchoes echoes() {
    std::sort(heard_.begin(), heard_.end());
    SonarEchoes out;
    out.fill(sonar_.max_range);
    for (std::size_t i = 0; i < std::min(heard_.size(), out.size()); ++i) {
      out[i] = std::max(heard_[i], sonar_.min_range);
    }
    return out;
  }

 private:
  void hear(const Shape* shape, const Pose& X_WS) {
    const auto distance = calcDistanceInCone(X_WR_, sonar_.half_cone, range(), *shape, X_WS);
    if (distance) heard_.push_back(*distance);
  }

  const SonarModel& sonar_;
  Pose X_WR_;
  std::vector<double> heard_;  // [m]
};

}  // namespace

std::optional<double> calcDistanceInCone(const Pose& X_WC, double half_angle, double farthest,
                                         const Shape& shape, const Pose& X_WS) {
  const Pose X_SC = X_WS.inverse() * X_WC;
  const Vec3 p = X_SC.translation();
  const Vec3 axis = X_SC.linear().col(0);
  const double bound = boundingRadius(shape);
  if (p.norm() - bound > farthest || !mayBeInCone(-p, bound, axis, half_angle)) return std::nullopt;
  const SurfacePoint nearest = calcSurfacePoint(shape, p);
  if (nearest.distance > farthest) return std::nullopt;
  if (nearest.distance <= 0 || -nearest.normal.dot(axis) >= std::cos(half_angle)) {
    return std::max(0.0, nearest.distance);
  }
  const double found = Rim(shape, p, axis, half_angle, farthest).nearest();
  if (found < farthest) return found;
  return std::nullopt;
}

SonarEchoes Sonar::listen(const Surroundings& around, const Pose& X_WR) const {
  Listener listener(model_.sonar, X_WR);
  for (const Obstacle& obstacle : around.world.obstacles) {
    listener.hear(obstacle.shape, obstacle.shape.X_BS);
  }
  for (std::size_t b = 0; b < around.balls.size(); ++b) {
    Shape sphere;
    sphere.size.x() = around.world.balls[b].radius;
    listener.hear(sphere, translation(around.balls[b].p_W));
  }
  for (std::size_t r = 0; r < around.robots.size(); ++r) {
    const RobotBody& robot = *around.robots[r];
    if (r == around.self || !listener.mayHear(robot.motion()[0].p_WB, kReach)) continue;
    for (std::size_t i = 0; i < robot.motion().size(); ++i) {
      listener.hear(robot.model().bodies[i].collisions, poseOf(robot.motion()[i]));
    }
  }
  return listener.echoes();
}

void Sonar::sample(const Surroundings& around, double dt, SensorFrame& frame) {
  since_ += dt;
  if (since_ > kPeriod - dt / 2) {
    since_ = 0;
    const std::vector<int>& receivers = model_.sonar.receivers;
    for (std::size_t i = 0; i < std::min(receivers.size(), echoes_.size()); ++i) {
      const Frame& place = model_.frames[static_cast<std::size_t>(receivers[i])];
      const RobotBody& self = *around.robots[around.self];
      const Pose X_WB = poseOf(self.motion()[static_cast<std::size_t>(place.body)]);
      echoes_[i] = listen(around, X_WB * place.X_BF);
    }
  }
  frame.sonar = echoes_;
}

}  // namespace nao::sim
