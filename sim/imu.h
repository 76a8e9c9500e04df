#pragma once

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/body_motion.h"

namespace nao::sim {

/// The inertial unit in the chest: accelerometer, gyroscope, and the torso's angles as the chest
/// board fuses them from both (it does not know the truth either). Sampled once per cycle.
class Imu {
 public:
  Imu(const RobotModel& model, double gravity);

  /// What the unit remembers between samples; a plain value.
  struct State {
    bool started = false;
    Vec3 v_W = Vec3::Zero();     // [m/s] of the unit, at the sample before
    Vec3 down_T = Vec3::Zero();  // unit vector, as the unit believes
    double yaw = 0;              // [rad]
  };
  void archive(Archive& archive);
  State& state() { return state_; }
  const State& state() const { return state_; }

  /// Fills in what accelerometer and gyroscope measure, on three axes; `cycle` is the time since
  /// the sample before.
  void sample(const std::vector<BodyMotion>& motion, Duration cycle, SensorFrame& frame);
  /// Then leaves the axes of the gyroscope that this robot has, and fills in the angles that the
  /// chest board makes of both. With two axes it knows no yaw (0), as the boards of V3.x and V4.
  void fuse(Duration cycle, SensorFrame& frame);

 private:
  void turn(const SensorFrame& frame, double dt);

  const RobotModel& model_;
  double gravity_;
  State state_;
};

}  // namespace nao::sim
