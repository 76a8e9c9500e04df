#include "walk_engine/preview_control.h"

#include "core/check.h"

namespace nao::walk {
namespace {

constexpr double kErrorWeight = 1.0;   // Qe [1/m^2]
constexpr double kJerkWeight = 1e-6;   // R [s^6/m^2], Kajita's ratio
constexpr int kMaxIterations = 20000;  // at 10 ms about 500 suffice

struct Augmented {
  Eigen::Matrix4d A;
  Eigen::Vector4d B;
  Eigen::Matrix<double, 4, 3> F;
};

// State: the tracking error, then the increments of position, velocity and acceleration.
Augmented augment(double height_over_gravity, double dt) {
  Eigen::Matrix3d A;
  A << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
  const Eigen::Vector3d b(dt * dt * dt / 6, dt * dt / 2, dt);
  const Eigen::RowVector3d c(1, 0, -height_over_gravity);
  Augmented system;
  system.F.topRows<1>() = c * A;
  system.F.bottomRows<3>() = A;
  system.A.setZero();
  system.A(0, 0) = 1;
  system.A.rightCols<3>() = system.F;
  system.B << c.dot(b), b;
  return system;
}

// The fixed point of K = A'KA - A'KB (R + B'KB)^-1 B'KA + Q.
Eigen::Matrix4d solveRiccati(const Augmented& system) {
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
  Q(0, 0) = kErrorWeight;
  Eigen::Matrix4d K = Q;
  for (int i = 0; i < kMaxIterations; ++i) {
    const Eigen::RowVector4d gain =
        (system.B.transpose() * K * system.A) / (kJerkWeight + system.B.dot(K * system.B));
    Eigen::Matrix4d next = system.A.transpose() * K * (system.A - system.B * gain) + Q;
    next = (0.5 * (next + next.transpose())).eval();
    const double change = (next - K).norm();
    K = next;
    if (change < 1e-11 * K.norm()) return K;
  }
  NAO_CHECK(!"the Riccati iteration converges for any pendulum");
  return K;
}

}  // namespace

PreviewControl::PreviewControl(double com_height, double gravity, double dt, int samples)
    : dt_(dt), height_over_gravity_(com_height / gravity) {
  const Augmented system = augment(height_over_gravity_, dt);
  const Eigen::Matrix4d K = solveRiccati(system);
  const double scale = 1 / (kJerkWeight + system.B.dot(K * system.B));
  const Eigen::RowVector4d BtK = system.B.transpose() * K;
  integral_gain_ = scale * BtK(0);
  state_gain_ = scale * BtK * system.F;
  const Eigen::Matrix4d closed = system.A - system.B * (scale * BtK * system.A);
  Eigen::Vector4d X = -closed.transpose() * K.col(0);
  preview_gain_.push_back(-integral_gain_);
  for (int j = 1; j < samples; ++j) {
    preview_gain_.push_back(scale * system.B.dot(X));
    X = closed.transpose() * X;
  }
}

double PreviewControl::calcZmp(const State& state) const {
  return state.position - height_over_gravity_ * state.acceleration;
}

void PreviewControl::step(const std::vector<double>& zmp, State& state) const {
  NAO_CHECK(zmp.size() > preview_gain_.size());
  state.error_sum += calcZmp(state) - zmp[0];
  // Everything relative to the present position: the law is the same wherever the robot walks.
  double jerk = -integral_gain_ * state.error_sum - state_gain_(1) * state.velocity -
                state_gain_(2) * state.acceleration;
  for (std::size_t j = 0; j < preview_gain_.size(); ++j) {
    jerk -= preview_gain_[j] * (zmp[j + 1] - state.position);
  }
  state.position += dt_ * (state.velocity + dt_ * (state.acceleration / 2 + dt_ * jerk / 6));
  state.velocity += dt_ * (state.acceleration + dt_ * jerk / 2);
  state.acceleration += dt_ * jerk;
}

}  // namespace nao::walk
