#include "sim/faults.h"

#include <algorithm>

#include "sim/fsr.h"

namespace nao::sim {
namespace {

constexpr const char* kBoards[] = {"Accelerometer", "Gyroscope", "Angles",
                                   "LFoot/FSR",     "RFoot/FSR", "Sonar"};
enum Board : std::size_t { kAccelerometer, kGyroscope, kAngles, kLeftFsr, kRightFsr, kSonar };

}  // namespace

Faults::Faults(const RobotModel& model, std::uint64_t seed, const std::string& name)
    : model_(model),
      fresh_(seed, name + ".faults"),
      random_(fresh_),
      dead_until_(model.jointCount()),
      sensors_(model.jointCount() + std::size(kBoards)) {}

void Faults::reset() {
  random_ = fresh_;
  dead_until_ = JointArray<SimTime>(model_.jointCount());
  sensors_.assign(sensors_.size(), {});
  any_ = false;
}

std::vector<std::string> Faults::sensorNames(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Actuator& actuator : model.actuators) names.push_back(actuator.name);
  for (const char* board : kBoards) names.emplace_back(board);
  return names;
}

std::optional<std::size_t> Faults::findSensor(const std::string& name) const {
  const auto names = sensorNames(model_);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

void Faults::freeze(std::size_t sensor, SimTime until) {
  sensors_[sensor].frozen_until = until;
  sensors_[sensor].holds = 0;
  any_ = true;
}

void Faults::disturb(std::size_t sensor, double sd, SimTime until) {
  sensors_[sensor].noisy_until = until;
  sensors_[sensor].sd = sd;
  any_ = true;
}

void Faults::alterCommand(JointCommand& command, SimTime now) const {
  for (std::size_t j = 0; j < model_.jointCount(); ++j) {
    if (dead_until_[j] > now) command.stiffness[j] = -1;
  }
}

void Faults::alterImu(SensorFrame& frame) {
  if (!any_) return;
  alter(model_.jointCount() + kAccelerometer, frame);
  alter(model_.jointCount() + kGyroscope, frame);
}

void Faults::alterSensors(SensorFrame& frame) {
  if (!any_) return;
  const std::size_t joints = model_.jointCount();
  for (std::size_t j = 0; j < joints; ++j) alter(j, frame);
  for (const std::size_t board : {kAngles, kLeftFsr, kRightFsr, kSonar})
    alter(joints + board, frame);
  for (std::size_t foot = 0; foot < model_.feet.size() && foot < 2; ++foot) {
    const Sensor& fsr = sensors_[joints + kLeftFsr + foot];
    if (std::max(fsr.frozen_until, fsr.noisy_until) <= frame.time) continue;
    addUp(model_.feet[foot].fsr, frame.feet[foot]);
  }
}

void Faults::alter(std::size_t index, SensorFrame& frame) {
  Sensor& sensor = sensors_[index];
  const auto values = valuesOf(index, frame);
  if (sensor.frozen_until > frame.time) {
    if (sensor.holds == 0) {
      sensor.held.clear();
      for (const double* value : values) sensor.held.push_back(*value);
      sensor.holds = 1;
    }
    for (std::size_t i = 0; i < values.size(); ++i) *values[i] = sensor.held[i];
  } else {
    sensor.holds = 0;
  }
  if (sensor.noisy_until <= frame.time) return;
  const bool positive = index >= model_.jointCount() + kLeftFsr;  // forces and distances
  for (double* value : values) {
    *value += sensor.sd * random_.normal();
    if (positive) *value = std::max(0.0, *value);
  }
}

std::vector<double*> Faults::valuesOf(std::size_t index, SensorFrame& frame) const {
  std::vector<double*> values;
  const auto addAll = [&values](auto& list) {
    for (double& value : list) values.push_back(&value);
  };
  if (index < model_.jointCount()) return {&frame.angle[index]};
  switch (index - model_.jointCount()) {
    case kAccelerometer:
      addAll(frame.accelerometer);
      break;
    case kGyroscope:
      addAll(frame.gyroscope);
      break;
    case kAngles:
      return {&frame.angle_x, &frame.angle_y, &frame.angle_z};
    case kLeftFsr:
      addAll(frame.feet[0].force);
      break;
    case kRightFsr:
      addAll(frame.feet[1].force);
      break;
    default:
      addAll(frame.sonar[0]);
      addAll(frame.sonar[1]);
  }
  return values;
}

void Faults::archive(Archive& archive) {
  archive.value(dead_until_);
  archive.value(any_);
  if (!any_) return;
  archive.value(random_);
  archive.each(sensors_, [&archive](Sensor& sensor) {
    archive.value(sensor.frozen_until);
    archive.value(sensor.noisy_until);
    archive.value(sensor.sd);
    archive.value(sensor.holds);
    archive.list(sensor.held);
  });
}

}  // namespace nao::sim
