#include "sim/imu.h"

#include <cmath>

namespace nao::sim {
namespace {

constexpr double kTrustTime = 1.0;  // [s] how slowly the accelerometer corrects the gyroscope
constexpr double kTrustBand = 2.0;  // [m/s^2] it does so only near rest; both free choices

}  // namespace

Imu::Imu(const RobotModel& model, double gravity) : model_(model), gravity_(gravity) {}

void Imu::sample(const std::vector<BodyMotion>& motion, Duration cycle, SensorFrame& frame) {
  const BodyMotion& body = motion[static_cast<std::size_t>(model_.imu_body)];
  const double dt = toSeconds(cycle);
  const Vec3 v_W = body.v_WB + body.w_WB.cross(body.R_WB * model_.p_BoImu);
  const Vec3 a_W = state_.started ? Vec3((v_W - state_.v_W) / dt) : Vec3(Vec3::Zero());
  state_.v_W = v_W;
  frame.accelerometer = body.R_WB.transpose() * (Vec3(0, 0, -gravity_) - a_W);
  frame.gyroscope = body.R_WB.transpose() * body.w_WB;
}

void Imu::fuse(Duration cycle, SensorFrame& frame) {
  if (!state_.started) state_.down_T = frame.accelerometer.normalized();
  state_.started = true;
  if (model_.gyro_axes < 3) frame.gyroscope.z() = 0;
  turn(frame, toSeconds(cycle));
  const Vec3& down = state_.down_T;
  frame.angle_x = std::atan2(-down.y(), -down.z());
  frame.angle_y = std::atan2(down.x(), std::hypot(down.y(), down.z()));
  frame.angle_z = model_.gyro_axes < 3 ? 0 : state_.yaw;
}

void Imu::archive(Archive& archive) {
  archive.value(state_.started);
  archive.numbers(state_.v_W);
  archive.numbers(state_.down_T);
  archive.value(state_.yaw);
}

void Imu::turn(const SensorFrame& frame, double dt) {
  Vec3& down = state_.down_T;
  state_.yaw = wrapAngle(state_.yaw - dt * down.dot(frame.gyroscope));
  down -= dt * frame.gyroscope.cross(down);
  const double strength = frame.accelerometer.norm();
  if (std::abs(strength - gravity_) < kTrustBand) {
    down += dt / kTrustTime * (frame.accelerometer / strength - down);
  }
  down.normalize();
}

}  // namespace nao::sim
