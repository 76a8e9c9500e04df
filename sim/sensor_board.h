#pragma once

#include "sim/battery.h"
#include "sim/effects/catalogue.h"
#include "sim/faults.h"
#include "sim/imu.h"
#include "sim/motor_heat.h"
#include "sim/phase.h"
#include "sim/sonar.h"
#include "sim/touch_sensors.h"

namespace nao::sim {

/// All sensors of one robot, sampled together once per cycle: encoders on the motors' side of the
/// gears, currents, temperatures, inertial unit, force sensors, sonar, touch and battery, each with
/// what the effects, and then faults, make of it.
class SensorBoard {
 public:
  SensorBoard(const RobotModel& model, double gravity);

  /// As a robot that has just been put down.
  void reset();

  MotorHeat& heat() { return heat_; }
  Battery& battery() { return battery_; }
  TouchSensors& touch() { return touch_; }
  const TouchSensors& touch() const { return touch_; }

  SensorFrame sample(const Surroundings& around, SimTime now, EffectChain& effects, Faults& faults,
                     const PhaseWatch* watch);

  void archive(Archive& archive);

 private:
  const RobotModel& model_;
  Imu imu_;
  MotorHeat heat_;
  Battery battery_;
  Sonar sonar_;
  TouchSensors touch_;
};

}  // namespace nao::sim
