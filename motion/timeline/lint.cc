#include "motion/timeline/lint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "motion/trajectory.h"

namespace nao::motion {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kSameAngle = 0.1 * kDegree;  // [rad] one step of a Nao's 12-bit encoders, 0.088
constexpr double kSameSpeed = 0.01;           // [rad/s] free choice: a thousandth of any motor's

double beyond(double value, double limit) { return std::abs(value) - std::abs(limit); }

// The course of all joints from the pose in which the motion begins.
class Course {
 public:
  Course(const Timeline& timeline, const JointArray<double>& start) : start_(start) {
    for (const Curve& curve : timeline.curves) {
      tracks_.push_back({curve.joint, Trajectory(start[curve.joint], curve.keys)});
    }
  }
  JointArray<double> at(double time) const {
    JointArray<double> angle = start_;
    for (const auto& [joint, trajectory] : tracks_) angle[joint] = trajectory.at(time);
    return angle;
  }

 private:
  JointArray<double> start_;
  std::vector<std::pair<Joint, Trajectory>> tracks_;
};

class Checker {
 public:
  Checker(const RobotModel& model, double dt) : model_(model), dt_(dt) {}

  void look(double time, const JointArray<double>& angle, const JointArray<double>& before) {
    for (std::size_t i = 0; i < model_.jointCount(); ++i) {
      const Actuator& actuator = model_.actuators[i];
      const double limit = std::clamp(angle[i], actuator.lower, actuator.upper);
      if (std::abs(angle[i] - limit) > kSameAngle) {
        log_.add({MotionFault::Kind::JointLimit, toJoint(i), time, angle[i], limit, {}});
      }
      const double speed = (angle[i] - before[i]) / dt_;
      if (!actuator.coordinates.empty() && beyond(speed, actuator.max_velocity) > kSameSpeed) {
        const double top = std::copysign(actuator.max_velocity, speed);
        log_.add({MotionFault::Kind::Velocity, toJoint(i), time, speed, top, {}});
      }
    }
    for (const CoupledLimit& limit : model_.coupled_limits) lookAt(limit, time, angle);
  }
  std::vector<MotionFault> take() { return log_.take(); }

 private:
  // Of what the joint's own range has left.
  void lookAt(const CoupledLimit& limit, double time, const JointArray<double>& angle) {
    const auto clamped = [&](Joint joint) {
      const Actuator& actuator = model_.actuators[index(joint)];
      return std::clamp(angle[joint], actuator.lower, actuator.upper);
    };
    const auto [low, high] = limit.rangeAt(clamped(limit.driver));
    const double asked = clamped(limit.limited);
    const double allowed = std::clamp(asked, low, high);
    if (std::abs(asked - allowed) <= kSameAngle) return;
    log_.add({MotionFault::Kind::CoupledLimit,
              limit.limited,
              time,
              asked,
              allowed,
              {model_.actuators[index(limit.driver)].name}});
  }

  const RobotModel& model_;
  double dt_;  // [s]
  FaultLog log_;
};

std::string number(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.1f %s", value, unit);
  return text;
}

std::string sentenceOf(const MotionFault& fault) {
  const double degrees = fault.value / kDegree;
  const double allowed = fault.limit / kDegree;
  switch (fault.kind) {
    case MotionFault::Kind::File:
    case MotionFault::Kind::Key:
      return fault.text;
    case MotionFault::Kind::JointLimit:
      return "asked for " + number(degrees, "degrees") + ", its limit is " +
             number(allowed, "degrees");
    case MotionFault::Kind::CoupledLimit:
      return "asked for " + number(degrees, "degrees") + ", " + fault.text + " leaves it " +
             number(allowed, "degrees");
    case MotionFault::Kind::Velocity:
      return "asked for " + number(degrees, "degrees/s") + ", its top speed is " +
             number(std::abs(allowed), "degrees/s");
    case MotionFault::Kind::Torque:
      return "its motor gave all it has at its speed, " + number(fault.value, "N m");
    case MotionFault::Kind::Collision:
      return fault.text + " pushed each other with up to " + number(fault.value, "N");
    case MotionFault::Kind::Fall:
      return "the robot fell: its torso tilts by " + number(degrees, "degrees");
  }
  return {};
}

}  // namespace

const char* nameOf(MotionFault::Kind kind) {
  switch (kind) {
    case MotionFault::Kind::File:
      return "file";
    case MotionFault::Kind::Key:
      return "key";
    case MotionFault::Kind::JointLimit:
      return "joint_limit";
    case MotionFault::Kind::CoupledLimit:
      return "coupled_limit";
    case MotionFault::Kind::Velocity:
      return "velocity";
    case MotionFault::Kind::Torque:
      return "torque";
    case MotionFault::Kind::Collision:
      return "self_collision";
    case MotionFault::Kind::Fall:
      return "fall";
  }
  return "";
}

void FaultLog::add(const Moment& moment) {
  for (auto fault = faults_.rbegin(); fault != faults_.rend(); ++fault) {
    if (fault->kind != moment.kind || fault->joint != moment.joint) continue;
    if (fault->text != moment.what || moment.time - fault->until > kGap) continue;
    fault->until = moment.time;
    if (std::abs(moment.value - moment.limit) > std::abs(fault->value - fault->limit)) {
      fault->value = moment.value;
      fault->limit = moment.limit;
    }
    return;
  }
  faults_.push_back({moment.kind, moment.joint, moment.time, moment.time, 0, moment.value,
                     moment.limit, moment.what});
}

std::vector<MotionFault> lint(const Timeline& timeline, const RobotModel& model,
                              const JointArray<double>& start) {
  const double dt = toSeconds(model.cycle);
  const Course course(timeline, start);
  Checker checker(model, dt);
  JointArray<double> before = start;
  const auto cycles = static_cast<int>(std::ceil(timeline.length / dt - 1e-6));
  for (int i = 1; i <= cycles; ++i) {
    const JointArray<double> angle = course.at(i * dt);
    checker.look(i * dt, angle, before);
    before = angle;
  }
  std::vector<MotionFault> faults = checker.take();
  for (const std::string& sentence : timeline.broken) {
    faults.push_back({MotionFault::Kind::File, {}, 0, 0, 0, 0, 0, sentence});
  }
  for (const KeyFault& key : timeline.key_faults) {
    faults.push_back(
        {MotionFault::Kind::Key, key.joint, key.time, key.time, 0, 0, 0, key.sentence});
  }
  return faults;
}

void describeFaults(const Timeline& timeline, const RobotModel& model,
                    std::vector<MotionFault>& faults) {
  std::stable_sort(faults.begin(), faults.end(),
                   [](const MotionFault& a, const MotionFault& b) { return a.time < b.time; });
  for (MotionFault& fault : faults) {
    fault.frame = frameAt(timeline, fault.joint, fault.time);
    const std::string sentence = sentenceOf(fault);
    const bool names_joint = fault.joint && fault.kind != MotionFault::Kind::Key;
    fault.text =
        names_joint ? model.actuators[index(*fault.joint)].name + ": " + sentence : sentence;
  }
}

}  // namespace nao::motion
