#include <algorithm>

#include "core/robot_model_parts.h"

namespace nao {
namespace {

using JointAngle = std::pair<Joint, double>;

// The two sides of a Nao mirror each other in what turns about an axis that lies in the plane
// between them.
double mirrorSign(const std::string& joint) {
  const bool mirrored = joint.find("Roll") != std::string::npos ||
                        joint.find("ElbowYaw") != std::string::npos ||
                        joint.find("WristYaw") != std::string::npos;
  return mirrored ? -1 : 1;
}

JointAngle angleOf(const std::string& actuator, double angle, Config& angles,
                   const std::string& key, const RobotModel& model) {
  const auto joint = model.findJoint(actuator);
  if (!joint) angles.reject(key, "a joint of this robot");
  // The ranges of a Nao's two legs differ by a hundredth.
  constexpr double kSlack = 0.02;  // [rad]
  const Actuator& range = model.actuators[index(*joint)];
  if (angle < range.lower - kSlack || angle > range.upper + kSlack) {
    angles.reject(key, "an angle in the range of " + actuator);
  }
  return {*joint, std::clamp(angle, range.lower, range.upper)};
}

void readAngles(Config& angles, const RobotModel& model, std::vector<JointAngle>& result) {
  for (const std::string& key : angles.keys()) {
    const double angle = angles.number(key);
    if (model.findJoint(key)) {
      result.push_back(angleOf(key, angle, angles, key, model));
      continue;
    }
    const JointAngle left = angleOf("L" + key, angle, angles, key, model);
    const JointAngle right = angleOf("R" + key, mirrorSign(key) * angle, angles, key, model);
    result.push_back(left);
    if (right.first != left.first) result.push_back(right);
  }
}

WayKey readKey(Config& config, const RobotModel& model) {
  WayKey key;
  key.time = config.number("time", kPositive);
  if (config.has("pitch")) {
    const std::vector<double> pitch = config.numbers("pitch", 2);
    key.pitch_low = pitch[0];
    key.pitch_high = pitch[1];
    key.patience = config.number("patience", kNotNegative);
  }
  config.map("angles", Config::Presence::Optional,
             [&](Config& angles) { readAngles(angles, model, key.angles); });
  return key;
}

}  // namespace

void readWays(const std::string& file, RobotModel& model) {
  Config::read(file, [&](Config& config) {
    config.list("ways", Config::Presence::Required, [&](Config& entry) {
      Way way;
      way.name = entry.text("name");
      way.from = entry.texts("from");
      way.to = entry.text("to");
      entry.list("keys", Config::Presence::Required,
                 [&](Config& key) { way.keys.push_back(readKey(key, model)); });
      model.ways.push_back(way);
    });
  });
}

}  // namespace nao
