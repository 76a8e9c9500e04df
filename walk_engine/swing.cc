#include "walk_engine/swing.h"

#include <algorithm>
#include <cmath>

namespace nao::walk {
Pose onFloor(const Pose2& place) {
  Pose pose = translation(Vec3(place.x, place.y, 0));
  pose.linear() = rotationFromRpy(0, 0, place.theta);
  return pose;
}

double calcSwingPart(double progress, const Tuning& tuning) {
  const double s = std::clamp(progress / (1 - tuning.swing_settle), 0.0, 1.0);
  return 0.5 * (1 - std::cos(M_PI * s));
}

Pose calcSwing(const Pose2& from, const Pose2& to, double progress, double height,
               const Tuning& tuning) {
  const double s = std::clamp(progress, 0.0, 1.0);
  const double along = calcSwingPart(s, tuning);
  const Pose2 place = {from.x + along * (to.x - from.x), from.y + along * (to.y - from.y),
                       wrapAngle(from.theta + along * wrapAngle(to.theta - from.theta))};
  Pose pose = onFloor(place);
  pose.translation().z() = height * 0.5 * (1 - std::cos(2 * M_PI * s));
  return pose;
}

}  // namespace nao::walk
