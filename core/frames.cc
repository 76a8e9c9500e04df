#include "core/frames.h"

#include <algorithm>
#include <cmath>

namespace nao {

double wrapAngle(double angle) {
  const double wrapped = std::remainder(angle, 2 * M_PI);
  return wrapped <= -M_PI ? M_PI : wrapped;
}

Pose2 compose(const Pose2& base, const Pose2& relative) {
  const double c = std::cos(base.theta);
  const double s = std::sin(base.theta);
  return {base.x + c * relative.x - s * relative.y, base.y + s * relative.x + c * relative.y,
          wrapAngle(base.theta + relative.theta)};
}

Pose2 relativeTo(const Pose2& base, const Pose2& target) {
  const double c = std::cos(base.theta);
  const double s = std::sin(base.theta);
  const double dx = target.x - base.x;
  const double dy = target.y - base.y;
  return {c * dx + s * dy, -s * dx + c * dy, wrapAngle(target.theta - base.theta)};
}

Mat3 rotationFromRpy(double roll, double pitch, double yaw) {
  return (Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * Eigen::AngleAxisd(pitch, Vec3::UnitY()) *
          Eigen::AngleAxisd(roll, Vec3::UnitX()))
      .toRotationMatrix();
}

Vec3 rpyOf(const Mat3& rotation) {
  return {std::atan2(rotation(2, 1), rotation(2, 2)),
          std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0)),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

Pose translation(const Vec3& p) {
  Pose pose = Pose::Identity();
  pose.translation() = p;
  return pose;
}

}  // namespace nao
