#include "sim/ball_body.h"

namespace nao::sim {

void BallState::archive(Archive& archive) {
  archive.numbers(p_W);
  archive.numbers(v_W);
  archive.numbers(w_W);
  archive.numbers(R_W);
}

double heightAboveGround(const Ball& model, const WorldModel& world, const BallState& ball) {
  return world.ground_normal.dot(ball.p_W) - model.radius;
}

BallState placedBall(const Ball& model, const WorldModel& world, const Vec3& p_W, const Vec3& v_W) {
  constexpr double kLying = 1e-4;  // [m] free choice: a tenth of a millimetre is on the ground
  BallState ball;
  ball.p_W = p_W;
  ball.v_W = v_W;
  const double height = heightAboveGround(model, world, ball);
  const Vec3& n = world.ground_normal;
  if (height < 0) ball.p_W.z() -= height / n.z();
  if (height < kLying) ball.w_W = n.cross(v_W - n.dot(v_W) * n) / model.radius;
  return ball;
}

void moveBall(const Ball& model, bool resting, double h, BallState& ball) {
  if (resting) {
    const double slower = 1 / (1 + h * model.rolling_deceleration);
    ball.v_W *= slower;
    ball.w_W *= slower;
  }
  ball.p_W += h * ball.v_W;
  const double turn = h * ball.w_W.norm();
  if (turn > 0) ball.R_W = Eigen::AngleAxisd(turn, ball.w_W.normalized()) * ball.R_W;
}

}  // namespace nao::sim
