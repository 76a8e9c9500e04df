#include "sim/touching.h"

#include <algorithm>
#include <cmath>

#include "sim/shape_distance.h"

namespace nao::sim {
namespace {

// Soft enough for an explicit step of 5 ms with a ball of 45 g (omega h = 1.3 < 2).
constexpr double kStiffness = 3000;  // [N/m]
constexpr double kDamping = 3;       // [N s/m]
constexpr double kReach = 0.45;      // [m] beyond this from its torso a robot touches nothing

Pose poseOf(const BodyMotion& body) {
  Pose X = Pose::Identity();
  X.linear() = body.R_WB;
  X.translation() = body.p_WB;
  return X;
}

}  // namespace

// Pushes along the surface's normal, never pulls.
Vec3 Touching::forceOn(const Sphere& sphere, const Shape& shape, const Pose& X_WS,
                       const Vec3& v_surface_W) {
  const Vec3 p_S = X_WS.inverse() * sphere.p_W;
  if (p_S.norm() > boundingRadius(shape) + sphere.radius) return Vec3::Zero();
  const SurfacePoint surface = calcSurfacePoint(shape, p_S);
  const double depth = sphere.radius - surface.distance;
  if (depth <= 0) return Vec3::Zero();
  const Vec3 normal_W = X_WS.linear() * surface.normal;
  const double closing = -normal_W.dot(sphere.v_W - v_surface_W);
  return std::max(0.0, kStiffness * depth + kDamping * closing) * normal_W;
}

void Touching::touchRobot(const RobotBody& robot, const Sphere& sphere,
                          std::vector<ExternalForce>& on_robot, Vec3& on_sphere) const {
  const std::vector<BodyMotion>& motion = robot.motion();
  if ((sphere.p_W - motion[0].p_WB).norm() > kReach + sphere.radius) return;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    for (const Shape& shape : robot.model().bodies[i].collisions) {
      const Vec3 v_W = motion[i].v_WB + motion[i].w_WB.cross(sphere.p_W - motion[i].p_WB);
      const Vec3 f_W = forceOn(sphere, shape, poseOf(motion[i]) * shape.X_BS, v_W);
      if (f_W.isZero(0)) continue;
      on_sphere += f_W;
      on_robot.push_back({static_cast<int>(i), sphere.p_W, -f_W});
    }
  }
}

Vec3 Touching::touchObstacles(const Sphere& sphere) const {
  Vec3 f_W = Vec3::Zero();
  for (const Obstacle& obstacle : world_.obstacles) {
    f_W += forceOn(sphere, obstacle.shape, obstacle.shape.X_BS, Vec3::Zero());
  }
  return f_W;
}

void Touching::calc(const std::vector<const RobotBody*>& robots,
                    const std::vector<BallState>& balls,
                    std::vector<std::vector<ExternalForce>>& on_robots,
                    std::vector<Vec3>& on_balls) const {
  on_robots.resize(robots.size());
  for (auto& forces : on_robots) forces.clear();
  on_balls.assign(balls.size(), Vec3::Zero());

  for (std::size_t b = 0; b < balls.size(); ++b) {
    const Sphere sphere{balls[b].p_W, balls[b].v_W, world_.balls[b].radius};
    on_balls[b] = touchObstacles(sphere);
    for (std::size_t r = 0; r < robots.size(); ++r) {
      touchRobot(*robots[r], sphere, on_robots[r], on_balls[b]);
    }
  }
  for (std::size_t r = 0; r < robots.size(); ++r) {
    if (robots.size() == 1 && world_.obstacles.empty()) break;
    for (const ContactSphere& contact : robots[r]->model().contact_spheres) {
      const BodyMotion& body = robots[r]->motion()[static_cast<std::size_t>(contact.body)];
      const Vec3 arm = body.R_WB * contact.p_B;
      const Sphere sphere{body.p_WB + arm, body.v_WB + body.w_WB.cross(arm), contact.radius};
      Vec3 f_W = touchObstacles(sphere);
      for (std::size_t other = 0; other < robots.size(); ++other) {
        if (other != r) touchRobot(*robots[other], sphere, on_robots[other], f_W);
      }
      if (!f_W.isZero(0)) on_robots[r].push_back({contact.body, sphere.p_W, f_W});
    }
  }
}

void Touching::stepBall(const Ball& model, const Vec3& f_W, double h, BallState& ball) const {
  ball.v_W += h * (f_W / model.mass - Vec3(0, 0, world_.gravity));
  const double height = ball.p_W.z() - model.radius;
  if (height + h * ball.v_W.z() <= 0) {  // on the ground: no bounce, and it rolls
    ball.v_W.z() = std::max(ball.v_W.z(), -height / h);
    ball.v_W.head<2>() /= 1 + h * model.rolling_deceleration;
    const Vec3 w_W(-ball.v_W.y() / model.radius, ball.v_W.x() / model.radius, 0);
    const double turn = w_W.norm() * h;
    if (turn > 0) ball.R_W = Eigen::AngleAxisd(turn, w_W.normalized()) * ball.R_W;
  }
  ball.p_W += h * ball.v_W;
}

}  // namespace nao::sim
