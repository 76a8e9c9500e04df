#include <algorithm>
#include <iterator>
#include <set>
#include <string>

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

// What motion tells of any body (motion/posture_family.h); other families are the posture file's.
constexpr const char* kBodyFamilies[] = {"Standing",  "Crouching",  "Sitting",
                                         "Knee",      "LyingBack",  "LyingBelly",
                                         "LyingLeft", "LyingRight", "Unknown"};

void requireFamily(const std::string& family, Config& entry, const std::string& key,
                   const RobotModel& model) {
  std::set<std::string> known(std::begin(kBodyFamilies), std::end(kBodyFamilies));
  for (const Posture& posture : model.postures) known.insert(posture.family);
  if (known.count(family) > 0) return;
  std::string all;
  for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
  entry.reject(key, "families of postures (" + all + "), not " + family);
}

WayKey readKey(Config& config, const RobotModel& model) {
  WayKey key;
  key.time = config.number("time", kPositive);
  if (config.has("pitch")) {
    const std::vector<double> pitch = config.numbers("pitch", 2);
    key.pitch_low = pitch[0];
    key.pitch_high = pitch[1];
    if (key.pitch_low >= key.pitch_high) config.reject("pitch", "a low angle and a higher one");
    key.patience = config.number("patience", kNotNegative);
  }
  config.map("angles", Config::Presence::Optional,
             [&](Config& angles) { readAngles(angles, model, key.angles); });
  return key;
}

Way readWay(Config& entry, const RobotModel& model) {
  Way way;
  way.name = entry.text("name");
  const auto is_same = [&](const Way& other) { return other.name == way.name; };
  if (std::any_of(model.ways.begin(), model.ways.end(), is_same)) {
    entry.reject("name", "a name that no other way has");
  }
  way.from = entry.texts("from");
  way.to = entry.text("to");
  for (const std::string& family : way.from) requireFamily(family, entry, "from", model);
  requireFamily(way.to, entry, "to", model);
  entry.list("keys", Config::Presence::Required,
             [&](Config& key) { way.keys.push_back(readKey(key, model)); });
  if (way.keys.empty()) entry.reject("keys", "one key or more");
  return way;
}

}  // namespace

void readWays(const std::string& file, RobotModel& model) {
  Config::read(file, [&](Config& config) {
    config.list("ways", Config::Presence::Required,
                [&](Config& entry) { model.ways.push_back(readWay(entry, model)); });
  });
}

}  // namespace nao
