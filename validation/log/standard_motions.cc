#include "validation/log/standard_motions.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/check.h"
#include "validation/log/excitation.h"

namespace nao::validation {
namespace {

constexpr double kMargin = 0.03;  // [rad] kept from stops and coupled limits: 1.7 degrees

// Of the top speed, free choices: ramps go to where the motor's voltage shows, those of a joint
// that narrows another's range only so fast that the other can make way.
constexpr double kRampSpeed = 0.85;
constexpr double kLimitedRampSpeed = 0.4;
constexpr double kDriverRampSpeed = 0.3;

struct Range {
  double low = 0;   // [rad]
  double high = 0;  // [rad]
};

// Where a held Nao may move every joint at the same time without touching itself, found by
// measuring the gaps of its collision solids along all motions. Right rolls and yaws mirror.
const std::map<std::string, Range>& safeRanges() {
  static const std::map<std::string, Range> kRanges{
      {"HeadYaw", {-2.0, 2.0}},        {"HeadPitch", {-0.64, 0.48}},
      {"LShoulderPitch", {-0.6, 1.9}}, {"LShoulderRoll", {0.6, 1.28}},
      {"LElbowYaw", {-1.7, 0.6}},      {"LElbowRoll", {-1.3, -0.07}},
      {"LWristYaw", {-1.7, 1.7}},      {"LHipYawPitch", {-0.32, 0.15}},
      {"LHipRoll", {0.24, 0.62}},      {"LHipPitch", {-1.1, 0.4}},
      {"LKneePitch", {-0.06, 1.7}},    {"LAnklePitch", {-1.15, 0.85}},
      {"LAnkleRoll", {-0.37, 0.73}},
  };
  return kRanges;
}

bool isMirrored(const std::string& left) {
  return left.find("Roll") != std::string::npos || left.find("ElbowYaw") != std::string::npos ||
         left.find("WristYaw") != std::string::npos;
}

Range findSafeRange(const Actuator& actuator) {
  const auto& ranges = safeRanges();
  auto found = ranges.find(actuator.name);
  if (found != ranges.end()) return found->second;
  if (actuator.name.front() == 'R') {
    found = ranges.find("L" + actuator.name.substr(1));
    if (found != ranges.end()) {
      const Range range = found->second;
      return isMirrored(found->first) ? Range{-range.high, -range.low} : range;
    }
  }
  const double quarter = (actuator.upper - actuator.lower) / 4;
  return {actuator.lower + quarter, actuator.upper - quarter};
}

// The margin, less where the range is narrow.
Range inside(double low, double high) {
  const double margin = std::min(kMargin, 0.15 * (high - low));
  return {low + margin, high - margin};
}

Range calcOwnRange(const Actuator& actuator) {
  const Range safe = findSafeRange(actuator);
  const Range ends = inside(actuator.lower, actuator.upper);
  return {std::max(safe.low, ends.low), std::min(safe.high, ends.high)};
}

double place(const Range& range, double u) {
  return (range.low + range.high) / 2 + u * (range.high - range.low) / 2;
}

Pace makePace(const RobotModel& model, std::size_t joint) {
  const Actuator& actuator = model.actuators[joint];
  const Range range = calcOwnRange(actuator);
  Pace pace;
  pace.joint = joint;
  pace.half_range = (range.high - range.low) / 2;
  pace.max_speed = actuator.max_velocity > 0 ? actuator.max_velocity : 1;
  pace.ramp_speed = kRampSpeed * pace.max_speed;
  for (const CoupledLimit& limit : model.coupled_limits) {
    if (index(limit.limited) == joint) {
      pace.limited = true;
      pace.ramp_speed = kLimitedRampSpeed * pace.max_speed;
    }
    if (index(limit.driver) == joint) pace.ramp_speed = kDriverRampSpeed * pace.max_speed;
  }
  return pace;
}

// Puts the joints into their ranges: -1 and 1 are the ends, 0 the middle.
JointArray<double> spread(const RobotModel& model, const JointArray<double>& u) {
  JointArray<double> angle(model.jointCount(), 0);
  std::vector<Range> range;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    range.push_back(calcOwnRange(model.actuators[j]));
    if (!model.actuators[j].coordinates.empty()) angle[j] = place(range[j], u[j]);
  }
  for (const CoupledLimit& limit : model.coupled_limits) {
    const auto [low, high] = limit.rangeAt(angle[limit.driver]);
    const Range allowed = inside(low, high);
    Range& own = range[index(limit.limited)];
    own = {std::max(own.low, allowed.low), std::min(own.high, allowed.high)};
    angle[limit.limited] = place(own, u[limit.limited]);
  }
  return angle;
}

using Shape = double (*)(const Pace&, double);
struct Kind {
  StandardMotion motion;
  Shape shape;
};

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> kKinds{
      {{"triangles", Split::Fit}, triangles}, {{"tones", Split::Fit}, tones},
      {{"reach", Split::Fit}, reach},         {{"stairs", Split::Fit}, stairs},
      {{"varied", Split::Select}, varied},    {{"crossing", Split::Test}, crossing},
      {{"quick", Split::Test}, quick},
  };
  return kKinds;
}

}  // namespace

const std::vector<StandardMotion>& standardMotions() {
  static const std::vector<StandardMotion> kMotions = [] {
    std::vector<StandardMotion> motions;
    for (const Kind& kind : kinds()) motions.push_back(kind.motion);
    return motions;
  }();
  return kMotions;
}

JointArray<double> standardAngles(const RobotModel& model, std::size_t motion, double t) {
  NAO_CHECK(motion < kinds().size());
  JointArray<double> u(model.jointCount(), 0);
  const double envelope = calcEnvelope(t, kStandardMotionTime);
  for (std::size_t j = 0; envelope > 0 && j < model.jointCount(); ++j) {
    if (model.actuators[j].coordinates.empty()) continue;
    u[j] = envelope * std::clamp(kinds()[motion].shape(makePace(model, j), t), -1.0, 1.0);
  }
  return spread(model, u);
}

JointArray<double> standardRest(const RobotModel& model) {
  return spread(model, JointArray<double>(model.jointCount(), 0));
}

std::optional<JointArray<double>> startPose(const RobotModel& model, const std::string& name) {
  if (name == kStandardRestPose) return standardRest(model);
  const Posture* posture = model.findPosture(name.empty() ? model.start_posture : name);
  if (posture == nullptr) return std::nullopt;
  return posture->angle;
}

void rejectStartPose(const RobotModel& model, const std::string& where, const std::string& name) {
  throw InputError("start_pose of " + where + ": expected a posture of " + model.name + " or '" +
                   kStandardRestPose + "', found '" + name + "'");
}

}  // namespace nao::validation
