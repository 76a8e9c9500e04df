#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/random.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/sim_time.h"

namespace nao::sim {

/// What breaks of one robot while it runs, and for how long: motors that give no torque, sensors
/// that stand still or report noise. Laws:
///   dead motor     as if its stiffness were below 0: off; it brakes as its board lets it
///   frozen sensor  reports what it reported first after the fault began
///   noisy sensor   each value, plus a normal random number of the given SD
/// Accelerometer and gyroscope fail before the chest board makes angles of them. One simulation
/// thread; all of it is state.
class Faults {
 public:
  /// `name` of the robot: noise has a stream of its own for each.
  Faults(const RobotModel& model, std::uint64_t seed, const std::string& name);

  void reset();

  void killJoint(Joint joint, SimTime until) { dead_until_[joint] = until; }
  void freeze(std::size_t sensor, SimTime until);
  void disturb(std::size_t sensor, double sd, SimTime until);

  /// Which sensors can fail: a joint's name for its encoder, then "Accelerometer", "Gyroscope",
  /// "Angles" (the torso's), "LFoot/FSR", "RFoot/FSR", "Sonar".
  static std::vector<std::string> sensorNames(const RobotModel& model);
  std::optional<std::size_t> findSensor(const std::string& name) const;

  void alterCommand(JointCommand& command, SimTime now) const;
  void alterImu(SensorFrame& frame);
  void alterSensors(SensorFrame& frame);

  void archive(Archive& archive);

 private:
  struct Sensor {
    SimTime frozen_until{};
    SimTime noisy_until{};
    double sd = 0;            // in the sensor's own unit
    std::uint64_t holds = 0;  // 1: `held` is what it reports while frozen
    std::vector<double> held;
  };
  void alter(std::size_t sensor, SensorFrame& frame);
  std::vector<double*> valuesOf(std::size_t sensor, SensorFrame& frame) const;

  const RobotModel& model_;
  const Random fresh_;
  Random random_;
  JointArray<SimTime> dead_until_;
  std::vector<Sensor> sensors_;
  bool any_ = false;  // a sensor failed once: else they cost nothing
};

}  // namespace nao::sim
