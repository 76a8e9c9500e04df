#include "walk_engine/swing.h"

#include <algorithm>
#include <cmath>

namespace nao::walk {
namespace {

// Minimum jerk from 0 to 1: no velocity or acceleration at the ends.
double minimumJerk(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10 + s * (6 * s - 15));
}

}  // namespace

Pose onFloor(const Pose2& place) {
  Pose pose = translation(Vec3(place.x, place.y, 0));
  pose.linear() = rotationFromRpy(0, 0, place.theta);
  return pose;
}

Pose calcSwing(const Pose2& from, const Pose2& to, double progress, double height,
               const Tuning& tuning) {
  const double s = std::clamp(progress, 0.0, 1.0);
  const double moving = 1 - tuning.swing_lead - tuning.swing_settle;
  const double along = minimumJerk((s - tuning.swing_lead) / moving);
  const Pose2 place = {from.x + along * (to.x - from.x), from.y + along * (to.y - from.y),
                       wrapAngle(from.theta + along * wrapAngle(to.theta - from.theta))};
  Pose pose = onFloor(place);
  pose.translation().z() = height * 0.5 * (1 - std::cos(2 * M_PI * s));
  return pose;
}

}  // namespace nao::walk
