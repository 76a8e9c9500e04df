#include "naoqi_api/memory/idle_devices.h"

#include <array>
#include <cstdlib>

namespace nao::memory {
namespace {

using rpc::Value;

constexpr char kDevices[] = "Device/SubDeviceList/";
constexpr std::array<const char*, 2> kSides = {"Left", "Right"};
constexpr std::array<const char*, 3> kColors = {"Red", "Green", "Blue"};

bool isNao(const RobotModel& model) { return model.feet.size() == 2; }
bool hasHands(const RobotModel& model) { return model.findJoint("LHand").has_value(); }

// 3.3 of "V3.3"; 0 if the file says something else.
double versionOf(const RobotModel& model) {
  const std::string& text = model.version;
  return text.empty() || text[0] != 'V' ? 0 : std::strtod(text.c_str() + 1, nullptr);
}

void add(Keys& keys, const std::string& device, const std::string& part) {
  keys.emplace_back(kDevices + device + "/" + part + "/Value", 0.0F);
}

void addLed(Keys& keys, const std::string& device, const std::string& led) {
  add(keys, device, "Led/" + led + "/Actuator");
}

// Eyes of 8 sectors in three colours, ears of 10 in blue.
void addFaceLeds(Keys& keys) {
  for (const std::string side : kSides) {
    for (const std::string color : kColors) {
      for (int angle = 0; angle < 360; angle += 45) {
        addLed(keys, "Face", color + "/" + side + "/" + std::to_string(angle) + "Deg");
      }
    }
    for (int angle = 0; angle < 360; angle += 36) {
      addLed(keys, "Ears", side + "/" + std::to_string(angle) + "Deg");
    }
  }
}

// On the head of V4 and later.
void addHeadLeds(Keys& keys) {
  for (const std::string side : kSides) {
    for (const char* number : {"0", "1", "2"}) addLed(keys, "Head", "Rear/" + side + "/" + number);
    for (const char* number : {"0", "1"}) addLed(keys, "Head", "Front/" + side + "/" + number);
    addLed(keys, "Head", "Middle/" + side + "/0");
  }
}

void addLeds(const RobotModel& model, Keys& keys) {
  addFaceLeds(keys);
  constexpr double kFirstWithHeadLeds = 4.0;
  if (versionOf(model) >= kFirstWithHeadLeds) addHeadLeds(keys);
  for (const char* device : {"ChestBoard", "LFoot", "RFoot"}) {
    for (const char* color : kColors) addLed(keys, device, color);
  }
  addLed(keys, "ChestBoard", "State");
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
  if (versionOf(model) >= 4.0) addDiagnosis(keys, "Head/Led");
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
  addLeds(model, keys);
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
