#include "sim/touch_sensors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nao::sim {
namespace {

constexpr double kReach = 0.035;  // [m] a sensor's patch; free, about its drawn size
constexpr double kForce = 1.0;    // [N] that switches it; estimate
// Of a bumper, above the sole's edge, which is no part of it: the bumpers are 10 mm above the sole.
constexpr double kUnderside = 0.007;  // [m]

enum Group { Head, LeftHand, RightHand, LeftFoot, RightFoot, Chest };

}  // namespace

TouchSensors::TouchSensors(const RobotModel& model) {
  add(model, "Head/Touch/Front", Head, 0);
  add(model, "Head/Touch/Middle", Head, 1);
  add(model, "Head/Touch/Rear", Head, 2);
  const std::array<const char*, 3> places{"Left", "Back", "Right"};
  for (int i = 0; i < 3; ++i) {
    const std::string place = places[static_cast<std::size_t>(i)];
    add(model, "LHand/Touch/" + place, LeftHand, i);
    add(model, "RHand/Touch/" + place, RightHand, i);
  }
  add(model, "LFoot/Bumper/Left", LeftFoot, 0);
  add(model, "LFoot/Bumper/Right", LeftFoot, 1);
  add(model, "RFoot/Bumper/Left", RightFoot, 0);
  add(model, "RFoot/Bumper/Right", RightFoot, 1);
  add(model, "ChestBoard/Button", Chest, 0);
}

void TouchSensors::add(const RobotModel& model, const std::string& name, int group, int place) {
  const auto frame = std::find_if(model.frames.begin(), model.frames.end(),
                                  [&](const Frame& f) { return f.name == name; });
  if (frame == model.frames.end()) return;
  const bool bumper = group == LeftFoot || group == RightFoot;
  sensors_.push_back({name, frame->body, frame->X_BF.translation(), bumper, group, place, {}});
}

void TouchSensors::reset() {
  for (Sensor& sensor : sensors_) sensor.pressed_until = {};
}

std::vector<std::string> TouchSensors::names() const {
  std::vector<std::string> names;
  for (const Sensor& sensor : sensors_) names.push_back(sensor.name);
  return names;
}

bool TouchSensors::press(const std::string& name, SimTime until) {
  for (Sensor& sensor : sensors_) {
    if (sensor.name != name) continue;
    sensor.pressed_until = until;
    return true;
  }
  return false;
}

bool TouchSensors::feels(const Sensor& sensor, const Surroundings& around) {
  const BodyMotion& body =
      around.robots[around.self]->motion()[static_cast<std::size_t>(sensor.body)];
  for (const TouchForce& force : around.contacts.forces) {
    if (force.robot != static_cast<int>(around.self) || force.body != sensor.body) continue;
    const Vec3 p_B = body.R_WB.transpose() * (force.p_W - body.p_WB);
    if ((p_B - sensor.p_B).norm() > kReach) continue;
    const Vec3 f_B = body.R_WB.transpose() * force.f_W;
    const double push = sensor.bumper ? -f_B.x() : f_B.norm();
    if (push < kForce) continue;
    if (sensor.bumper && push < std::abs(f_B.z())) continue;               // the floor's friction
    if (sensor.bumper && p_B.z() < sensor.p_B.z() - kUnderside) continue;  // at a landing: jolts
    return true;
  }
  return false;
}

bool& TouchSensors::target(const Sensor& sensor, SensorFrame& frame) {
  const auto place = static_cast<std::size_t>(sensor.place);
  switch (sensor.group) {
    case Head:
      return frame.touch.head[place];
    case LeftHand:
      return frame.touch.hand[0][place];
    case RightHand:
      return frame.touch.hand[1][place];
    case LeftFoot:
      return frame.feet[0].bumper[place];
    case RightFoot:
      return frame.feet[1].bumper[place];
    default:
      return frame.touch.chest_button;
  }
}

void TouchSensors::sample(const Surroundings& around, SimTime now, SensorFrame& frame) const {
  for (const Sensor& sensor : sensors_) {
    target(sensor, frame) = sensor.pressed_until > now || feels(sensor, around);
  }
}

void TouchSensors::archive(Archive& archive) {
  for (Sensor& sensor : sensors_) archive.value(sensor.pressed_until);
}

}  // namespace nao::sim
