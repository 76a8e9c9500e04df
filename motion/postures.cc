#include "motion/postures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/phases.h"
#include "motion/posture_family.h"
#include "motion/posture_graph.h"

namespace nao::motion {
namespace {

// Free choices, wide enough for servos under load and narrow enough to tell postures apart.
constexpr double kNear = 0.3;      // [rad] per leg joint
constexpr double kArrived = 0.25;  // [rad] per joint
constexpr double kUpright = 0.6;   // [rad] torso from the vertical
constexpr double kLeaning = 0.8;   // [rad] likewise, of one that sits: Sit leans back by 33 degrees
constexpr double kLying = 1.0;     // [rad]

// A robot on its feet bears this part of the joints' top speed while its legs bend; above it the
// swing of the torso throws it over.
constexpr double kBalancedSpeed = 0.3;
constexpr double kPostureRamp = 0.5;  // [s] into and out of the motion

constexpr double kUnhurriedFraction = 0.7;  // of that speed, when nobody asked for one
constexpr double kStiffenTime = 0.6;        // [s]
constexpr double kRelaxTime = 0.3;          // [s]

bool torsoIsAsIn(const Posture& posture, const SensorFrame& measured) {
  if (posture.family == "LyingBack") return measured.angle_y < -kLying;
  if (posture.family == "LyingBelly") return measured.angle_y > kLying;
  const double tilt = std::acos(std::cos(measured.angle_x) * std::cos(measured.angle_y));
  return tilt < (posture.family == "Sitting" ? kLeaning : kUpright);
}

bool isOnFeet(const Posture& posture) {
  return posture.family == "Standing" || posture.family == "Crouching";
}

// Hands hold things and heads look around: neither says what posture a body is in.
JointSet bodyJoints(const RobotModel& model) {
  JointSet joints = allJoints(model) & ~jointsOfGroup(model, "Head");
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    if (model.actuators[i].coordinates.empty()) joints.reset(i);
  }
  return joints;
}

double distance(const JointSet& joints, const JointArray<double>& a, const JointArray<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (joints.test(i)) largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

JointSet legs(const RobotModel& model) {
  return jointsOfGroup(model, "LLeg") | jointsOfGroup(model, "RLeg");
}

/// Chosen when its turn comes, from where the robot then is.
class WayToPosture final : public Phase {
 public:
  WayToPosture(const Posture& target, double fraction) : target_(target), fraction_(fraction) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override {
    body.self_guarded = true;  // arms that bear the body pass close to it
    return way_->advance(dt, mine, body);
  }
  std::string failure() const override { return way_->failure(); }
  std::unique_ptr<Phase> clone() const override { return std::make_unique<WayToPosture>(*this); }
  void archive(Archive& archive) override;

 private:
  const Posture& target_;
  double fraction_;
  ValuePtr<Phase> way_;
};

void WayToPosture::begin(Body& body) {
  const RobotModel& model = body.model;
  std::vector<ValuePtr<Phase>> phases;
  const std::string family = bodyFamily(model, body.measured);
  const auto route = findRoute(model, family, target_.family);
  if (!model.ways.empty() && route) {
    for (const Way* way : *route) phases.emplace_back(follow(*way));
    const Way* around = findWayAround(model, target_.family);
    const bool is_there = isIn(model, body.measured, target_);
    if (around != nullptr && !is_there) phases.emplace_back(follow(*around));
  } else if (const Posture* crouch = model.findPosture("Crouch")) {
    // Without ways a robot on its feet makes itself small before it goes to the ground.
    const Posture* now = findCurrentPosture(model, body.measured);
    if (now != nullptr && isOnFeet(*now) && !isOnFeet(target_)) {
      phases.emplace_back(glideTo(model, *crouch, fraction_));
    }
  }
  phases.emplace_back(glideTo(model, target_, fraction_));
  phases.emplace_back(std::make_unique<CheckPosture>(target_));
  way_ = std::make_unique<Sequence>(std::move(phases));
  way_->begin(body);
}

void WayToPosture::archive(Archive& archive) {
  JointArray<double> angle = target_.angle;
  archive.value(angle);
  archive.value(fraction_);
  if (way_) way_->archive(archive);
}

bool legsAreStiff(const Body& body) {
  const JointSet leg_joints = legs(body.model);
  for (std::size_t i = 0; i < body.angle.size(); ++i) {
    if (leg_joints.test(i) && body.stiffness.value()[i] <= 0) return false;
  }
  return true;
}

}  // namespace

bool legsAreNear(const RobotModel& model, const JointArray<double>& angle, const Posture& posture) {
  return distance(legs(model), angle, posture.angle) < kNear;
}

bool isIn(const RobotModel& model, const SensorFrame& measured, const Posture& posture) {
  if (!model.feet.empty() && !torsoIsAsIn(posture, measured)) return false;
  return distance(bodyJoints(model), measured.angle, posture.angle) < kArrived;
}

const Posture* findCurrentPosture(const RobotModel& model, const SensorFrame& measured) {
  const Posture* nearest = nullptr;
  double least = 0;
  for (const Posture& posture : model.postures) {
    if (!isIn(model, measured, posture)) continue;
    const double away = distance(bodyJoints(model), measured.angle, posture.angle);
    if (nearest == nullptr || away < least) nearest = &posture;
    if (nearest == &posture) least = away;
  }
  return nearest;
}

std::string currentFamily(const RobotModel& model, const SensorFrame& measured) {
  if (const Posture* posture = findCurrentPosture(model, measured)) return posture->family;
  return bodyFamily(model, measured);
}

std::unique_ptr<Phase> glideTo(const RobotModel& model, const Posture& posture, double fraction) {
  Glide::Course course;
  course.joints = allJoints(model);
  course.target = posture.angle;
  course.fraction = fraction * (model.feet.empty() ? 1 : kBalancedSpeed);
  course.ramp = kPostureRamp;
  return std::make_unique<Glide>(course);
}

std::unique_ptr<Phase> goToPosture(const RobotModel& /*model*/, const Posture& target,
                                   double fraction) {
  return std::make_unique<WayToPosture>(target, fraction);
}

std::unique_ptr<Phase> wakeUp(const RobotModel& model) {
  std::vector<ValuePtr<Phase>> phases;
  phases.push_back(std::make_unique<RampStiffness>(1.0, kStiffenTime));
  const Posture* crouch = model.findPosture("Crouch");
  const Posture* stand = model.findPosture("StandInit");
  if (crouch != nullptr && stand != nullptr) {
    const auto crouches = [&model, crouch](const Body& body) {
      return body.upright && legsAreNear(model, body.angle, *crouch);
    };
    phases.push_back(
        std::make_unique<OnlyIf>(crouches, glideTo(model, *stand, kUnhurriedFraction)));
  }
  return std::make_unique<Sequence>(std::move(phases));
}

std::unique_ptr<Phase> rest(const RobotModel& model) {
  std::vector<ValuePtr<Phase>> phases;
  if (const Posture* crouch = model.findPosture("Crouch")) {
    const auto stands = [&model](const Body& body) {
      const Posture* now = findCurrentPosture(model, body.measured);
      const bool sits = now != nullptr && !isOnFeet(*now);
      return body.upright && !sits && legsAreStiff(body);
    };
    phases.push_back(std::make_unique<OnlyIf>(stands, glideTo(model, *crouch, kUnhurriedFraction)));
  }
  phases.push_back(std::make_unique<RampStiffness>(0.0, kRelaxTime));
  return std::make_unique<Sequence>(std::move(phases));
}

}  // namespace nao::motion
