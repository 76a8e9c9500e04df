#pragma once

#include <almath/tools/altrigonometry.h>
#include <almath/types/alpose2d.h>
#include <almath/types/alposition2d.h>
#include <almath/types/alposition3d.h>
#include <almath/types/alposition6d.h>
#include <almath/types/alquaternion.h>
#include <almath/types/alrotation3d.h>
#include <almath/types/altransform.h>
#include <almath/types/alvelocity3d.h>
#include <almath/types/alvelocity6d.h>

namespace AL {
namespace Math {

/// Moves `value` into [low, high]; true if it was outside.
inline bool clipData(float low, float high, float& value) {
  const float before = value;
  value = value < low ? low : value > high ? high : value;
  return value != before;
}

inline Position2D position2DFromPose2D(const Pose2D& pose) { return Position2D(pose.x, pose.y); }
inline Pose2D pose2DFromPosition2D(const Position2D& position, float angle = 0) {
  return Pose2D(position.x, position.y, angle);
}
inline Position3D position3DFromPosition6D(const Position6D& position) {
  return Position3D(position.x, position.y, position.z);
}
inline Position6D position6DFromPose2D(const Pose2D& pose) {
  return Position6D(pose.x, pose.y, 0, 0, 0, pose.theta);
}
inline Pose2D pose2DFromPosition6D(const Position6D& position) {
  return Pose2D(position.x, position.y, position.wz);
}

}  // namespace Math
}  // namespace AL
