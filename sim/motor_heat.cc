#include "sim/motor_heat.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace nao::sim {
namespace {

constexpr double kVoltage = 21.6;  // [V] of the battery (NAOqi 2.1.4.13 documentation, battery)
constexpr double kAmbient = 25;    // [deg C]
// Winding to air of a motor of 17 to 24 mm in a closed shell, and the time it takes: the order of
// maxon's RE-max sheets, with little air. Estimates, plausible 10 to 30 K/W and 200 to 800 s.
constexpr double kHeatResistance = 20;  // [K/W]
constexpr double kTimeConstant = 400;   // [s]
// Where the boards begin to hold back, by 30 %, and altogether. Estimates; documented are the three
// degrees of it alone (NAOqi 2.1.4.13 documentation, ALBodyTemperature).
constexpr double kWarnings[] = {75, 85, 95};  // [deg C]

std::uint8_t warning(double temperature) {
  return static_cast<std::uint8_t>(
      std::count_if(std::begin(kWarnings), std::end(kWarnings),
                    [&](double limit) { return temperature >= limit; }));
}

}  // namespace

MotorHeat::MotorHeat(const RobotModel& model) : motors_(model.jointCount()) {
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    const Actuator& a = model.actuators[j];
    if (a.stall_torque <= 0 || a.no_load_speed <= 0) continue;
    const double k = kVoltage / a.no_load_speed;
    motors_[j] = {1 / (a.efficiency * k), kVoltage * k / a.stall_torque};
  }
  reset();
}

void MotorHeat::reset() { temperature_ = JointArray<double>(motors_.size(), kAmbient); }

double MotorHeat::timeConstant() { return kTimeConstant; }

double MotorHeat::calcFinalTemperature(std::size_t joint, double torque) const {
  const double current = motors_[joint].ampere_per_torque * torque;
  return kAmbient + kHeatResistance * current * current * motors_[joint].resistance;
}

void MotorHeat::sample(const JointArray<double>& torque, double dt, SensorFrame& frame) {
  const double keeps = std::exp(-dt / kTimeConstant);
  frame.current = JointArray<double>(motors_.size());
  frame.overheating = JointArray<std::uint8_t>(motors_.size());
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    const double end = calcFinalTemperature(j, torque[j]);
    temperature_[j] = end + keeps * (temperature_[j] - end);
    frame.current[j] = motors_[j].ampere_per_torque * std::abs(torque[j]);
    frame.overheating[j] = warning(temperature_[j]);
  }
  frame.temperature = temperature_;
}

void MotorHeat::archive(Archive& archive) { archive.value(temperature_); }

}  // namespace nao::sim
