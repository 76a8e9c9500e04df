#include "motion/posture_family.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nao::motion {
namespace {

// Free choices, between what the named postures show and what a leaning robot still bears.
constexpr double kLyingUp = 0.77;     // cosine: a side of the torso within 40 degrees of up
constexpr double kUprightUp = 0.6;    // cosine: 53 degrees; Sit leans back by 17, bows reach 45
constexpr double kFlatSole = 0.9;     // cosine: 26 degrees
constexpr double kSeatHeight = 0.13;  // [m] hips above the lowest point: seated 0.09, Crouch 0.17
constexpr double kCrouchKnee = 1.5;   // [rad] StandInit 0.7, Crouch 2.1
constexpr double kKneeHeight = 0.06;  // [m] a knee that rests on the ground

/// Bodies by forward kinematics, heights along `up`. Small and seldom needed: no cache.
class Heights {
 public:
  Heights(const RobotModel& model, const SensorFrame& measured) : model_(model) {
    up_ = upInTorso(measured);
    X_TB_.resize(model.bodies.size(), Pose::Identity());
    for (std::size_t i = 1; i < model.bodies.size(); ++i) {
      const Body& body = model.bodies[i];
      const double angle = measured.angle[model.coordinates[i - 1].joint];
      const Pose turn(Eigen::AngleAxisd(angle, body.axis));
      X_TB_[i] = X_TB_[static_cast<std::size_t>(body.parent)] * body.X_PB * turn;
    }
  }

  double of(int body) const { return up_.dot(X_TB_[static_cast<std::size_t>(body)].translation()); }
  double lowestOf(const FootModel& foot) const {
    double lowest = 1;
    for (const Eigen::Vector2d& corner : foot.outline) {
      const Vec3 p_S(corner.x(), corner.y(), 0);
      lowest = std::min(lowest, up_.dot(poseOf(foot) * p_S));
    }
    return lowest;
  }
  double uprightness(const FootModel& foot) const { return up_.dot(poseOf(foot).linear().col(2)); }

 private:
  Pose poseOf(const FootModel& foot) const {
    return X_TB_[static_cast<std::size_t>(foot.body)] * foot.X_BS;
  }

  const RobotModel& model_;
  Vec3 up_;
  std::vector<Pose> X_TB_;
};

std::string uprightFamily(const RobotModel& model, const SensorFrame& measured) {
  const auto left_hip = model.findBody("LHipPitch"), right_hip = model.findBody("RHipPitch");
  const auto left_knee = model.findBody("LKneePitch"), right_knee = model.findBody("RKneePitch");
  const auto knee = model.findJoint("LKneePitch"), other_knee = model.findJoint("RKneePitch");
  if (model.feet.size() != 2 || !left_hip || !right_hip || !left_knee || !right_knee || !knee ||
      !other_knee) {
    return "Unknown";
  }
  const Heights heights(model, measured);
  const FootModel& left = model.feet[0];
  const FootModel& right = model.feet[1];
  const double soles = std::min(heights.lowestOf(left), heights.lowestOf(right));
  const double knees = std::min(heights.of(*left_knee), heights.of(*right_knee));
  const double hips = std::min(heights.of(*left_hip), heights.of(*right_hip));
  if (hips - soles < kSeatHeight) return "Sitting";
  if (knees - soles < kKneeHeight) return "Knee";
  const double flat = std::min(heights.uprightness(left), heights.uprightness(right));
  if (flat < kFlatSole) return "Unknown";
  const double bent = std::max(measured.angle[*knee], measured.angle[*other_knee]);
  return bent > kCrouchKnee ? "Crouching" : "Standing";
}

}  // namespace

Vec3 upInTorso(const SensorFrame& measured) {
  const double roll = measured.angle_x, pitch = measured.angle_y;
  return {-std::sin(pitch), std::cos(pitch) * std::sin(roll), std::cos(pitch) * std::cos(roll)};
}

double torsoPitch(const SensorFrame& measured) {
  const Vec3 up = upInTorso(measured);
  return std::atan2(-up.x(), up.z());
}

std::string bodyFamily(const RobotModel& model, const SensorFrame& measured) {
  const Vec3 up = upInTorso(measured);
  if (up.x() > kLyingUp) return "LyingBack";
  if (up.x() < -kLyingUp) return "LyingBelly";
  if (up.y() > kLyingUp) return "LyingRight";
  if (up.y() < -kLyingUp) return "LyingLeft";
  return up.z() > kUprightUp ? uprightFamily(model, measured) : "Unknown";
}

}  // namespace nao::motion
