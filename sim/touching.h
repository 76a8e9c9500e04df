#pragma once

#include <vector>

#include "core/world_model.h"
#include "sim/robot_body.h"

namespace nao::sim {

/// A ball as a point mass with a radius: it rolls without slipping, slowed by
/// a = -rolling_deceleration * v, and does not spin against what it touches.
struct BallState {
  Vec3 p_W = Vec3::Zero();  // [m]
  Vec3 v_W = Vec3::Zero();  // [m/s]
  Mat3 R_W = Mat3::Identity();
};

/// Contact between robots, balls and obstacles: soft springs computed from the state at the start
/// of the step, in a fixed order, and handed to each side as an external force. A robot touches
/// with its contact spheres, and is touched on its collision shapes.
class Touching {
 public:
  explicit Touching(const WorldModel& world) : world_(world) {}

  /// Clears all forces, then adds those of every pair. `on_robots` and `on_balls` are by index.
  void calc(const std::vector<const RobotBody*>& robots, const std::vector<BallState>& balls,
            std::vector<std::vector<ExternalForce>>& on_robots, std::vector<Vec3>& on_balls) const;

  /// Lets the force `f_W` [N] and the ground act on a ball for `h` [s].
  void stepBall(const Ball& model, const Vec3& f_W, double h, BallState& ball) const;

 private:
  struct Sphere {  // something round that may touch a solid
    Vec3 p_W, v_W;
    double radius;
  };
  static Vec3 forceOn(const Sphere& sphere, const Shape& shape, const Pose& X_WS,
                      const Vec3& v_surface_W);
  void touchRobot(const RobotBody& robot, const Sphere& sphere,
                  std::vector<ExternalForce>& on_robot, Vec3& on_sphere) const;
  Vec3 touchObstacles(const Sphere& sphere) const;

  const WorldModel& world_;
};

}  // namespace nao::sim
