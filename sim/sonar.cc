#include "sim/sonar.h"

#include <algorithm>
#include <cmath>

#include "sim/shape_distance.h"

namespace nao::sim {
namespace {

// Where the nearest point of a thing lies outside the cone, rays look for one inside.
constexpr int kRings = 4;  // of rays between axis and rim; free: 30 degrees of wall to 1 cm
constexpr int kRaysPerRing = 24;
constexpr int kSphereSteps = 32;     // of one ray
constexpr double kOnSurface = 5e-4;  // [m]
constexpr double kReach = 0.7;       // [m] no part of a robot is farther from its torso

// Along a ray from the apex, by steps as long as nothing is near (sphere tracing); to `farthest`.
double trace(const Vec3& p, const Vec3& way, double farthest, const Shape& shape) {
  double along = 0;
  for (int k = 0; k < kSphereSteps && along < farthest; ++k) {
    const double free = calcSurfacePoint(shape, p + along * way).distance;
    if (free < kOnSurface) return along;
    along += free;
  }
  return farthest;
}

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

  void hear(const Shape& shape, const Pose& X_WS) { hear(&shape, X_WS); }

  // Things in one body are heard as one.
  void hear(const std::vector<Shape>& shapes, const Pose& X_WB) {
    std::optional<double> nearest;
    for (const Shape& shape : shapes) {
      const auto distance =
          calcDistanceInCone(X_WR_, sonar_.half_cone, range(), shape, X_WB * shape.X_BS);
      if (distance && (!nearest || *distance < *nearest)) nearest = distance;
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
  if (p.norm() - bound > farthest) return std::nullopt;
  const SurfacePoint nearest = calcSurfacePoint(shape, p);
  if (nearest.distance > farthest) return std::nullopt;
  if (nearest.distance <= 0 || -nearest.normal.dot(axis) >= std::cos(half_angle)) {
    return std::max(0.0, nearest.distance);
  }
  double found = farthest;
  for (int ring = 1; ring <= kRings; ++ring) {
    const double angle = half_angle * ring / kRings;
    for (int k = 0; k < kRaysPerRing; ++k) {
      const double turn = 2 * M_PI * k / kRaysPerRing;
      const Vec3 way_C(std::cos(angle), std::sin(angle) * std::cos(turn),
                       std::sin(angle) * std::sin(turn));
      found = std::min(found, trace(p, X_SC.linear() * way_C, found, shape));
    }
  }
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
    const double away = (robot.motion()[0].p_WB - listener.place()).norm();
    if (r == around.self || away > listener.range() + kReach) continue;
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
