#include "core/robot_model_parts.h"

namespace nao {
namespace {

// Effects act on motors by name; a group stands for all its motors.
void addJoints(Config& entry, const std::string& name, const RobotModel& model,
               std::vector<Joint>& joints) {
  if (const auto joint = model.findJoint(name)) {
    joints.push_back(*joint);
    return;
  }
  const auto group = model.groups.find(name);
  if (group == model.groups.end()) entry.reject("joints", "names of actuators or groups");
  for (const std::string& member : group->second) addJoints(entry, member, model, joints);
}

EffectSetting readEffect(Config& entry, const RobotModel& model) {
  EffectSetting setting;
  setting.name = entry.text("effect");
  setting.place = entry.place();
  for (const std::string& key : entry.keys()) {
    if (key == "effect" || key == "joints") continue;
    setting.parameters[key] = entry.number(key);
  }
  if (entry.has("joints")) {
    for (const std::string& name : entry.texts("joints")) {
      addJoints(entry, name, model, setting.joints);
    }
  }
  return setting;
}

}  // namespace

std::vector<EffectSetting> readEffects(Config& body, const std::string& key,
                                       const RobotModel& model) {
  std::vector<EffectSetting> settings;
  body.list(key, Config::Presence::Optional,
            [&](Config& entry) { settings.push_back(readEffect(entry, model)); });
  return settings;
}

}  // namespace nao
