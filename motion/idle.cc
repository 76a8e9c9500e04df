#include "motion/idle.h"

#include <algorithm>
#include <cmath>

namespace nao::motion {
namespace {

// How far each joint goes at amplitude 0, free choices within the documented 5 degrees. The legs
// bend with the soles flat and the torso upright; all begin towards the side where every standing
// posture has room.
struct Swing {
  const char* joint;
  double angle;  // [rad]
};
constexpr double kDegree = M_PI / 180;
constexpr Swing kSwings[] = {{"HeadPitch", -2 * kDegree},       {"LShoulderPitch", 2 * kDegree},
                             {"RShoulderPitch", 2 * kDegree},   {"LShoulderRoll", 1.5 * kDegree},
                             {"RShoulderRoll", -1.5 * kDegree}, {"LElbowRoll", -2.5 * kDegree},
                             {"RElbowRoll", 2.5 * kDegree},     {"LHipPitch", -1.25 * kDegree},
                             {"RHipPitch", -1.25 * kDegree},    {"LKneePitch", 2.5 * kDegree},
                             {"RKneePitch", 2.5 * kDegree},     {"LAnklePitch", -1.25 * kDegree},
                             {"RAnklePitch", -1.25 * kDegree}};

constexpr double kFade = 1.0;                  // [s] free choice: smooth to the eye
constexpr double kReturnSpeed = 0.05;          // of top speed: 20 degrees/s, free choice
constexpr double kStandingLoad = 0.5;          // of the weight, on the feet; who sits has less
constexpr double kGravity = 9.81;              // [m/s^2]
constexpr double kSlowest = 5, kFastest = 30;  // [1/min]

double smooth(double w) { return w * w * (3 - 2 * w); }

}  // namespace

SetBreath clipToStable(const SetBreath& config) {
  const double bpm = std::clamp(config.beats_per_minute, kSlowest, kFastest);
  const double most = (kFastest - bpm) / (kFastest - kSlowest);
  return {bpm, std::clamp(config.amplitude, 0.0, most)};
}

Idle::Idle(const RobotModel& model)
    : swing_(model.jointCount()), reference_(model.jointCount()), offset_(model.jointCount()) {
  for (const Swing& swing : kSwings) {
    if (const auto joint = model.findJoint(swing.joint)) swing_[*joint] = swing.angle;
  }
  groups_[0].joints = jointsOfGroup(model, "Head");
  groups_[1].joints = jointsOfGroup(model, "LArm");
  groups_[2].joints = jointsOfGroup(model, "RArm");
  groups_[3].joints = jointsOfGroup(model, "LLeg") | jointsOfGroup(model, "RLeg");
}

void Idle::set(const SetIdle& request, const Body& body) {
  for (const Joint joint : request.joints) {
    breath_.set(index(joint), request.mode == SetIdle::Mode::Breath);
    posture_.set(index(joint), request.mode == SetIdle::Mode::Posture);
    reference_[joint] = body.angle[joint] - offset_[joint];
  }
}

bool Idle::stands(const Body& body) {
  if (!body.upright || !body.awake) return false;
  const double load = body.measured.feet[0].total + body.measured.feet[1].total;
  return load >= kStandingLoad * body.model.totalMass() * kGravity;
}

void Idle::update(double dt, const JointSet& held, Body& body) {
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (held.test(i)) offset_[i] = 0;  // it is now part of where the other began
  }
  const bool standing = breath_.any() && stands(body);
  phase_ = std::fmod(phase_ + 2 * M_PI * config_.beats_per_minute / 60 * dt, 2 * M_PI);
  bool at_rest = true;
  for (Group& group : groups_) {
    breathe(dt, held, standing, group, body);
    at_rest = at_rest && group.weight == 0;
  }
  if (at_rest) phase_ = 0;
  giveBack(dt, posture_ & ~held, body);
}

void Idle::breathe(double dt, const JointSet& held, bool standing, Group& group, Body& body) {
  const bool all = (group.joints & ~breath_).none() && (group.joints & held).none();
  const double way = standing && all && group.joints.any() ? dt / kFade : -dt / kFade;
  group.weight = std::clamp(group.weight + way, 0.0, 1.0);
  const double share = smooth(group.weight) * (1 + config_.amplitude) * (1 - std::cos(phase_)) / 2;
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (!group.joints.test(i) || held.test(i)) continue;
    const double offset = share * swing_[i];
    body.angle[i] += offset - offset_[i];
    offset_[i] = offset;
  }
}

void Idle::giveBack(double dt, const JointSet& free, Body& body) const {
  for (std::size_t i = 0; i < offset_.size(); ++i) {
    if (!free.test(i)) continue;
    const double most = kReturnSpeed * body.model.actuators[i].max_velocity * dt;
    body.angle[i] += std::clamp(reference_[i] + offset_[i] - body.angle[i], -most, most);
  }
}

void Idle::archive(Archive& archive) {
  for (Group& group : groups_) archive.value(group.weight);
  archive.value(breath_);
  archive.value(posture_);
  archive.value(reference_);
  archive.value(offset_);
  archive.value(config_);
  archive.value(phase_);
}

}  // namespace nao::motion
