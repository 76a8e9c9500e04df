#pragma once

#include <vector>

#include "core/archive.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::sim {

/// Current and temperature of the motors, as their boards report them. A motor is a winding:
///   i = torque / (efficiency k),  k = V / no-load speed  (the constant of torque and of back-EMF)
///   P = i^2 R,                    R = V k / stall torque
///   c T' = P - (T - ambient) / r, with time constant c r
/// k and R at the joint follow from data sheets alone; the heat path is an estimate. Exact for a
/// current that is constant over a cycle.
class MotorHeat {
 public:
  explicit MotorHeat(const RobotModel& model);

  /// All motors at ambient temperature.
  void reset();

  /// As if the motor had come to this temperature [deg C].
  void heat(Joint joint, double temperature) { temperature_[joint] = temperature; }

  /// Takes in what the motors gave over the last `dt` [s], and reports.
  void sample(const JointArray<double>& torque, double dt, SensorFrame& frame);

  /// The temperature [deg C] that this torque [N m] leads to if held for ever.
  double calcFinalTemperature(std::size_t joint, double torque) const;
  static double timeConstant();  // [s]

  void archive(Archive& archive);

 private:
  struct Motor {
    double ampere_per_torque = 0;  // [A/(N m)] at the joint, losses included
    double resistance = 0;         // [Ohm]
  };
  std::vector<Motor> motors_;  // by joint
  JointArray<double> temperature_;
};

}  // namespace nao::sim
