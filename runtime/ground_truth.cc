#include "runtime/ground_truth.h"

#include <cmath>

namespace nao::runtime {
namespace {

Pose2 onFloor(const Pose& X_WF) {
  const Vec3 x_W = X_WF.linear().col(0);
  return {X_WF.translation().x(), X_WF.translation().y(), std::atan2(x_W.y(), x_W.x())};
}

}  // namespace

Pose2 calcFloorPose(const RobotModel& model, const std::vector<Pose>& X_WB) {
  if (model.feet.size() != 2) return onFloor(X_WB.front());
  Pose2 feet[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const FootModel& foot = model.feet[i];
    feet[i] = onFloor(X_WB[static_cast<std::size_t>(foot.body)] * foot.X_BS);
  }
  const double half_turn = wrapAngle(feet[1].theta - feet[0].theta) / 2;
  return {(feet[0].x + feet[1].x) / 2, (feet[0].y + feet[1].y) / 2,
          wrapAngle(feet[0].theta + half_turn)};
}

}  // namespace nao::runtime
