#include "naoqi_api/memory/device_views.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace nao::memory {
namespace {

using motion::MotionState;
using rpc::Value;

constexpr char kDevices[] = "Device/SubDeviceList/";
constexpr double kGravity = 9.80665;  // [m/s^2] a kilogram of NaoQi's is this many newton

// Every number of a device is a 32-bit float.
Value number(double value) { return Value(static_cast<float>(value)); }

// A sensor of a device: `read` maps a SensorFrame to a number.
template <class F>
void addSensor(Views& views, const std::string& key, F read, KeyType type = KeyType::Data) {
  views[key] = {type, [read](const SensorFrame& sensors, const MotionState& /*state*/) {
                  return number(read(sensors));
                }};
}

// A sensor that reports a whole number.
template <class F>
void addInteger(Views& views, const std::string& key, F read) {
  views[key] = {KeyType::Data, [read](const SensorFrame& sensors, const MotionState& /*state*/) {
                  return Value(static_cast<std::int32_t>(read(sensors)));
                }};
}

// Something that is commanded: `read` maps a MotionState to a value.
template <class F>
void addState(Views& views, const std::string& key, F read, KeyType type = KeyType::Data) {
  views[key] = {type, [read](const SensorFrame& /*sensors*/, const MotionState& state) {
                  return Value(read(state));
                }};
}

void addJoint(const std::string& name, Joint joint, Views& views) {
  const std::string device = kDevices + name + "/";
  addState(views, device + "Position/Actuator/Value", [joint](const MotionState& state) {
    return static_cast<float>(state.command.angle[joint]);
  });
  addState(views, device + "Hardness/Actuator/Value", [joint](const MotionState& state) {
    return static_cast<float>(state.command.stiffness[joint]);
  });
  addSensor(views, device + "Position/Sensor/Value",
            [joint](const SensorFrame& sensors) { return sensors.angle[joint]; });
  addSensor(views, device + "ElectricCurrent/Sensor/Value",
            [joint](const SensorFrame& sensors) { return sensors.current[joint]; });
  addSensor(views, device + "Temperature/Sensor/Value",
            [joint](const SensorFrame& sensors) { return sensors.temperature[joint]; });
  addInteger(views, device + "Temperature/Sensor/Status",
             [joint](const SensorFrame& sensors) { return sensors.overheating[joint]; });
}

// The mean over the joints as ALSensors tells it. (NAOqi 2.8 documentation: below 0.05, between,
// above 0.95)
std::int32_t bodyStiffness(const MotionState& state) {
  if (state.stiffness.size() == 0) return 0;
  double sum = 0;
  for (const double stiffness : state.stiffness) sum += std::max(stiffness, 0.0);
  const double mean = sum / static_cast<double>(state.stiffness.size());
  if (mean < 0.05) return 0;
  return mean > 0.95 ? 2 : 1;
}

// What stays at room temperature: the motors that have done least show it.
double ambient(const SensorFrame& sensors) {
  if (sensors.temperature.size() == 0) return 0;
  return *std::min_element(sensors.temperature.begin(), sensors.temperature.end());
}

std::string footDevice(Foot foot) {
  return std::string(kDevices) + (foot == Foot::Left ? "LFoot/" : "RFoot/");
}

void addForces(Foot foot, Views& views) {
  const std::string fsr = footDevice(foot) + "FSR/";
  const std::array<const char*, 4> names = {"FrontLeft", "FrontRight", "RearLeft", "RearRight"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    addSensor(views, fsr + names[i] + "/Sensor/Value", [foot, i](const SensorFrame& sensors) {
      return sensors.feet[index(foot)].force[i] / kGravity;
    });
  }
  const auto weight = [foot](const SensorFrame& sensors) {
    return sensors.feet[index(foot)].total / kGravity;
  };
  addSensor(views, fsr + "TotalWeight/Sensor/Value", weight);
  addSensor(views, fsr + "CenterOfPressure/X/Sensor/Value",
            [foot](const SensorFrame& sensors) { return sensors.feet[index(foot)].cop_x; });
  addSensor(views, fsr + "CenterOfPressure/Y/Sensor/Value",
            [foot](const SensorFrame& sensors) { return sensors.feet[index(foot)].cop_y; });
  addSensor(views, foot == Foot::Left ? "leftFootTotalWeight" : "rightFootTotalWeight", weight);
}

void addBumpers(Foot foot, Views& views) {
  const std::string bumper = footDevice(foot) + "Bumper/";
  addSensor(views, bumper + "Left/Sensor/Value", [foot](const SensorFrame& sensors) {
    return sensors.feet[index(foot)].bumper[0] ? 1 : 0;
  });
  addSensor(views, bumper + "Right/Sensor/Value", [foot](const SensorFrame& sensors) {
    return sensors.feet[index(foot)].bumper[1] ? 1 : 0;
  });
  addSensor(
      views, foot == Foot::Left ? "LeftBumperPressed" : "RightBumperPressed",
      [foot](const SensorFrame& sensors) {
        const auto& pressed = sensors.feet[index(foot)].bumper;
        return pressed[0] || pressed[1] ? 1 : 0;
      },
      KeyType::Event);
}

// A foot touches the ground when it bears this much; ALFsr's own threshold is not public, so this
// is a choice, well above the noise of the sensors and below a twentieth of the robot's weight.
constexpr double kContactWeight = 0.2;  // [kg]

bool touches(const SensorFrame& sensors, Foot foot) {
  return sensors.feet[index(foot)].total > kContactWeight * kGravity;
}

// What the receiver reports stays as it is: its greatest distance where no (further) echo came, 0
// while the sonar is off (NAOqi 2.1.4.13 documentation, sonar).
void addSonar(const std::string& side, std::size_t receiver, Views& views) {
  const std::string key = std::string(kDevices) + "US/" + side + "/Sensor/Value";
  for (std::size_t echo = 0; echo < kSonarEchoes; ++echo) {
    addSensor(views, echo == 0 ? key : key + std::to_string(echo),
              [receiver, echo](const SensorFrame& s) { return s.sonar[receiver][echo]; });
  }
}

// A tactile sensor and the event it raises.
template <class F>
void addTouch(Views& views, const std::string& device, const std::string& event, F touched) {
  const auto read = [touched](const SensorFrame& sensors) { return touched(sensors) ? 1 : 0; };
  addSensor(views, kDevices + device + "/Sensor/Value", read);
  addSensor(views, event, read, KeyType::Event);
}

void addHead(Views& views) {
  const std::array<const char*, 3> places = {"Front", "Middle", "Rear"};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::string place = places[i];
    addTouch(views, "Head/Touch/" + place, place + "TactilTouched",
             [i](const SensorFrame& sensors) { return sensors.touch.head[i]; });
  }
}

void addHands(Views& views) {
  const std::array<const char*, 2> sides = {"Left", "Right"};
  const std::array<const char*, 3> places = {"Left", "Back", "Right"};
  for (std::size_t hand = 0; hand < sides.size(); ++hand) {
    const std::string side = sides[hand];
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string place = places[i];
      addTouch(views, side.substr(0, 1) + "Hand/Touch/" + place, "Hand" + side + place + "Touched",
               [hand, i](const SensorFrame& sensors) { return sensors.touch.hand[hand][i]; });
    }
  }
}

void addBattery(Views& views) {
  const std::string battery = std::string(kDevices) + "Battery/";
  addSensor(views, battery + "Charge/Sensor/Value",
            [](const SensorFrame& sensors) { return sensors.battery.charge; });
  addSensor(views, battery + "Current/Sensor/Value",
            [](const SensorFrame& sensors) { return sensors.battery.current; });
  addSensor(views, battery + "Temperature/Sensor/Value",
            [](const SensorFrame& sensors) { return sensors.battery.temperature; });
}

}  // namespace

void addJointViews(const RobotModel& model, Views& views) {
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    addJoint(model.actuators[i].name, toJoint(i), views);
  }
}

void addMotionViews(const RobotModel& model, Views& views) {
  const auto body = model.groups.find("Body");
  const std::vector<std::string> names =
      body == model.groups.end() ? std::vector<std::string>() : body->second;
  for (const std::string& name : names) {
    const std::optional<Joint> joint = model.findJoint(name);
    if (!joint) continue;
    addSensor(views, "Motion/Position/Sensor/" + name,
              [joint](const SensorFrame& sensors) { return sensors.angle[*joint]; });
    addState(views, "Motion/Position/Command/" + name, [joint](const MotionState& state) {
      return static_cast<float>(state.command.angle[*joint]);
    });
    addState(views, "Motion/Stiffness/Command/" + name, [joint](const MotionState& state) {
      return static_cast<float>(state.command.stiffness[*joint]);
    });
  }
  constexpr KeyType kEvent = KeyType::Event;
  addState(
      views, "robotIsWakeUp", [](const MotionState& state) { return state.awake; }, kEvent);
  addState(
      views, "robotIsFalling", [](const MotionState& state) { return state.falling; }, kEvent);
  addState(
      views, "ALMotion/RobotIsFalling", [](const MotionState& state) { return state.falling; },
      kEvent);
  addState(views, "BodyStiffnessChanged", bodyStiffness, kEvent);
  addState(
      views, "robotHasFallen", [](const MotionState& state) { return state.fallen; }, kEvent);
}

void addInertialViews(Views& views) {
  const std::array<const char*, 3> axes = {"X", "Y", "Z"};
  const std::string device = std::string(kDevices) + "InertialSensor/";
  const std::string value = "/Sensor/Value";
  for (int i = 0; i < 3; ++i) {
    const auto acceleration = [i](const SensorFrame& sensors) { return sensors.accelerometer[i]; };
    const auto rate = [i](const SensorFrame& sensors) { return sensors.gyroscope[i]; };
    addSensor(views, device + "Accelerometer" + axes[i] + value, acceleration);
    addSensor(views, device + "Acc" + axes[i] + value, acceleration);
    addSensor(views, device + "Gyroscope" + axes[i] + value, rate);
    addSensor(views, device + "Gyr" + axes[i] + value, rate);
  }
  // The rates have no offset, so what they are taken against is 0.
  addSensor(views, device + "GyrRef" + value, [](const SensorFrame&) { return 0; });
  addSensor(views, device + "AngleX" + value, [](const SensorFrame& s) { return s.angle_x; });
  addSensor(views, device + "AngleY" + value, [](const SensorFrame& s) { return s.angle_y; });
  addSensor(views, device + "AngleZ" + value, [](const SensorFrame& s) { return s.angle_z; });
}

void addFootViews(const RobotModel& model, Views& views) {
  if (model.feet.size() != 2) return;
  for (const Foot foot : {Foot::Left, Foot::Right}) {
    addForces(foot, views);
    addBumpers(foot, views);
    addSensor(views, foot == Foot::Left ? "leftFootContact" : "rightFootContact",
              [foot](const SensorFrame& sensors) { return touches(sensors, foot) ? 1 : 0; });
  }
  const auto any = [](const SensorFrame& sensors) {
    return touches(sensors, Foot::Left) || touches(sensors, Foot::Right);
  };
  addSensor(views, "footContact",
            [any](const SensorFrame& sensors) { return any(sensors) ? 1 : 0; });
  views["footContactChanged"] = {KeyType::Event,
                                 [any](const SensorFrame& sensors, const MotionState& /*state*/) {
                                   return Value(any(sensors));
                                 }};
}

void addBoardViews(const RobotModel& model, Views& views) {
  const std::string devices = kDevices;
  addBattery(views);
  views["DCM/Time"] = {KeyType::Data, [](const SensorFrame& sensors, const MotionState&) {
                         using std::chrono::milliseconds;
                         const auto time = sensors.time.time_since_epoch();
                         const auto ms = std::chrono::duration_cast<milliseconds>(time).count();
                         return Value(static_cast<std::int32_t>(ms & 0x7fffffff));
                       }};
  if (model.feet.size() != 2) return;  // what follows is on a Nao
  addSensor(views, devices + "Head/Temperature/Sensor/Value", ambient);
  addTouch(views, "ChestBoard/Button", "ChestButtonPressed",
           [](const SensorFrame& sensors) { return sensors.touch.chest_button; });
  addHead(views);
  if (model.findJoint("LHand")) addHands(views);
  addSonar("Left", 0, views);
  addSonar("Right", 1, views);
  addSensor(views, devices + "US/Sensor/Value", [](const SensorFrame& sensors) {
    return std::min(sensors.sonar[0][0], sensors.sonar[1][0]);
  });
}

void addLedViews(const RobotModel& model, Views& views) {
  const std::vector<std::string> names = ledNames(model);
  for (std::size_t i = 0; i < names.size(); ++i) {
    addSensor(views, kDevices + names[i] + "/Actuator/Value",
              [i](const SensorFrame& sensors) { return sensors.leds[i]; });
  }
}

}  // namespace nao::memory
