#include "naoqi_api/memory/idle_devices.h"

#include <array>

#include "core/leds.h"

namespace nao::memory {
namespace {

using rpc::Value;

constexpr char kDevices[] = "Device/SubDeviceList/";

bool isNao(const RobotModel& model) { return model.feet.size() == 2; }
bool hasHands(const RobotModel& model) { return model.findJoint("LHand").has_value(); }

void add(Keys& keys, const std::string& device, const std::string& part) {
  keys.emplace_back(kDevices + device + "/" + part + "/Value", 0.0F);
}

void addDiagnosis(Keys& keys, const std::string& device) {
  for (const std::string kind : {"Active", "Passive"}) {
    keys.emplace_back("Diagnosis/" + kind + "/" + device + "/Error", 0);
  }
}

void addDiagnoses(const RobotModel& model, Keys& keys) {
  for (const char* device :
       {"Head/Touch", "Chest/Button", "LFoot/Bumper", "RFoot/Bumper", "Gyrometer", "Accelerometer",
        "Face/Led", "Ears/Led", "ChestBoard/Led", "LFoot/Led", "RFoot/Led", "USSensor", "Battery",
        "LFoot/FSR", "RFoot/FSR"}) {
    addDiagnosis(keys, device);
  }
  keys.emplace_back("Diagnosis/Temperature/Battery/Error", 0);
  if (!findLeds(ledNames(model), "BrainLeds").empty()) addDiagnosis(keys, "Head/Led");
  if (!hasHands(model)) return;
  addDiagnosis(keys, "LHand/Touch");
  addDiagnosis(keys, "RHand/Touch");
}

void addLimits(const Actuator& actuator, Keys& keys) {
  for (const char* side : {"Actuator", "Sensor"}) {
    const std::string position = kDevices + actuator.name + "/Position/" + side;
    keys.emplace_back(position + "/Min", static_cast<float>(actuator.lower));
    keys.emplace_back(position + "/Max", static_cast<float>(actuator.upper));
  }
}

void addForceSensorPlaces(const RobotModel& model, Keys& keys) {
  const std::array<const char*, 4> names = {"FrontLeft", "FrontRight", "RearLeft", "RearRight"};
  for (std::size_t foot = 0; foot < model.feet.size(); ++foot) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string sensor =
          std::string(kDevices) + (foot == 0 ? "LFoot" : "RFoot") + "/FSR/" + names[i] + "/Sensor/";
      const Vec3& place = model.feet[foot].fsr[i];
      keys.emplace_back(sensor + "XPosition", static_cast<float>(place.x()));
      keys.emplace_back(sensor + "YPosition", static_cast<float>(place.y()));
    }
  }
}

}  // namespace

Keys idleDevices(const RobotModel& model) {
  Keys keys;
  for (const Actuator& actuator : model.actuators) {
    addDiagnosis(keys, actuator.name);
    keys.emplace_back("Diagnosis/Temperature/" + actuator.name + "/Error", 0);
  }
  if (!isNao(model)) return keys;
  add(keys, "ChestBoard", "Led/State/Actuator");
  addDiagnoses(model, keys);
  add(keys, "US", "Actuator");
  return keys;
}

Keys fixedKeys(const RobotModel& model, const std::string& name) {
  Keys keys;
  for (const Actuator& actuator : model.actuators) addLimits(actuator, keys);
  addForceSensorPlaces(model, keys);
  keys.emplace_back("Device/DeviceList/ChestBoard/BodyNickName", name);
  keys.emplace_back("Device/DeviceList/ChestBoard/BodyId", "SIM-" + model.name + "-" + name);
  if (!isNao(model)) return keys;

  // Shapes as on a real V5.0: type Nao, base version V5.0, version 5.0.0.
  const std::string version =
      model.version.empty() ? std::string() : model.version.substr(1) + ".0";
  for (const std::string part : {"Head", "Body"}) {
    const std::string config = "RobotConfig/" + part + "/";
    keys.emplace_back(config + "Type", "Nao");
    keys.emplace_back(config + "BaseVersion", model.version);
    keys.emplace_back(config + "Version", version);
  }
  keys.emplace_back("RobotConfig/Head/HeadId", "SIM-" + name);
  keys.emplace_back("RobotConfig/Head/FullHeadId", "SIM-" + name);
  keys.emplace_back("RobotConfig/Body/SoftwareRequirement", "2.1.4.13");
  std::vector<std::string> devices = {"LeftArm", "RightArm", "Legs", "Foot", "Camera"};
  if (hasHands(model)) devices.insert(devices.end(), {"Hand/Left", "Hand/Right"});
  for (const std::string& device : devices) {
    keys.emplace_back("RobotConfig/Body/Device/" + device + "/Version", version);
  }
  return keys;
}

}  // namespace nao::memory
