#pragma once

#include "core/archive.h"
#include "core/world_model.h"

namespace nao::sim {

/// A ball as a rigid sphere. It rolls because friction makes it, slowed by a = -c v,
/// c = Ball::rolling_deceleration, while it rests on something.
struct BallState {
  Vec3 p_W = Vec3::Zero();  // [m]
  Vec3 v_W = Vec3::Zero();  // [m/s]
  Vec3 w_W = Vec3::Zero();  // [rad/s]
  Mat3 R_W = Mat3::Identity();

  void archive(Archive& archive);
};

/// At `p_W` with `v_W`; if it lies on the ground it rolls there without slipping.
BallState placedBall(const Ball& model, const WorldModel& world, const Vec3& p_W, const Vec3& v_W);

/// How high [m] the ball's lowest point is above the ground's plane.
double heightAboveGround(const Ball& model, const WorldModel& world, const BallState& ball);

/// Moves on by `h` [s] with the velocities it has; `resting`: something bears it.
void moveBall(const Ball& model, bool resting, double h, BallState& ball);

}  // namespace nao::sim
