#pragma once

#include <almath/tools/altrigonometry.h>
#include <almath/types/alaxismask.h>
#include <almath/types/aldisplacement.h>
#include <almath/types/alpose2d.h>
#include <almath/types/alposition2d.h>
#include <almath/types/alposition3d.h>
#include <almath/types/alposition6d.h>
#include <almath/types/alpositionandvelocity.h>
#include <almath/types/alquaternion.h>
#include <almath/types/alrotation.h>
#include <almath/types/alrotation3d.h>
#include <almath/types/altransform.h>
#include <almath/types/altransformandvelocity6d.h>
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

/// A point of the pose's frame as seen from outside [m].
inline Position2D operator*(const Pose2D& pose, const Position2D& p) {
  const float c = std::cos(pose.theta), s = std::sin(pose.theta);
  return Position2D(pose.x + c * p.x - s * p.y, pose.y + s * p.x + c * p.y);
}
/// The place turned by `theta` [rad] about the origin; the heading stays as it is.
inline void changeReferencePose2D(const float& theta, const Pose2D& pose, Pose2D& turned) {
  const Position2D place = Pose2D(0, 0, theta) * Position2D(pose.x, pose.y);
  turned = Pose2D(place.x, place.y, pose.theta);
}
inline void changeReferencePose2DInPlace(const float& theta, Pose2D& pose) {
  changeReferencePose2D(theta, pose, pose);
}

inline Position2D position2DFromPose2D(const Pose2D& pose) { return Position2D(pose.x, pose.y); }
inline void position2DFromPose2DInPlace(const Pose2D& pose, Position2D& position) {
  position = position2DFromPose2D(pose);
}
inline Pose2D pose2DFromPosition2D(const Position2D& position, float angle = 0) {
  return Pose2D(position.x, position.y, angle);
}
inline void pose2DFromPosition2DInPlace(const Position2D& position, float angle, Pose2D& pose) {
  pose = pose2DFromPosition2D(position, angle);
}
inline Position3D position3DFromPosition6D(const Position6D& position) {
  return Position3D(position.x, position.y, position.z);
}
inline Position6D position6DFromPosition3D(const Position3D& position) {
  return Position6D(position.x, position.y, position.z, 0, 0, 0);
}
inline void position6DFromPosition3DInPlace(const Position3D& position, Position6D& result) {
  result = position6DFromPosition3D(position);
}
inline Position6D position6DFromPose2D(const Pose2D& pose) {
  return Position6D(pose.x, pose.y, 0, 0, 0, pose.theta);
}
inline void position6DFromPose2DInPlace(const Pose2D& pose, Position6D& result) {
  result = position6DFromPose2D(pose);
}
inline Pose2D pose2DFromPosition6D(const Position6D& position) {
  return Pose2D(position.x, position.y, position.wz);
}
inline void pose2DFromPosition6DInPlace(const Position6D& position, Pose2D& pose) {
  pose = pose2DFromPosition6D(position);
}
/// Number by number: where one second leads.
inline Position6D position6DFromVelocity6D(const Velocity6D& v) {
  return Position6D(v.xd, v.yd, v.zd, v.wxd, v.wyd, v.wzd);
}

/// By `angle` [rad] about `axis`. @throws std::runtime_error if it has no length.
inline Rotation rotationFromAngleDirection(const float& angle, const Position3D& axis) {
  return Rotation::fromAngleDirection(angle, axis.x, axis.y, axis.z);
}
inline Velocity3D operator*(const Rotation& turn, const Velocity3D& v) {
  return 1.0f * (turn * Position3D(v.xd, v.yd, v.zd));
}
/// Of where it takes the axes, which are of length 1 and at right angles; not checked.
inline Rotation rotationFromAxesXYZ(const Position3D& x, const Position3D& y, const Position3D& z) {
  return Rotation::fromAxes(x, y, z);
}
inline Rotation rotationFromAxesXY(const Position3D& x, const Position3D& y) {
  return Rotation::fromAxes(x, y, x.crossProduct(y));
}
inline Rotation rotationFromAxesXZ(const Position3D& x, const Position3D& z) {
  return Rotation::fromAxes(x, z.crossProduct(x), z);
}
inline Rotation rotationFromAxesYZ(const Position3D& y, const Position3D& z) {
  return Rotation::fromAxes(y.crossProduct(z), y, z);
}
/// @throws std::runtime_error for a quaternion of 0.
inline void rotationFromQuaternion(const Quaternion& q, Rotation& turn) {
  turn = Rotation::fromQuaternion(q.w, q.x, q.y, q.z);
}
/// The turns x, then y, then z that it is made of [rad]; wy within [-pi/2, pi/2]. Where x and z
/// turn about the same axis, wz is 0.
inline Rotation3D rotation3DFromRotation(const Rotation& turn) {
  const float cos_y = std::sqrt(turn.r1_c1 * turn.r1_c1 + turn.r2_c1 * turn.r2_c1);
  const float wy = std::atan2(-turn.r3_c1, cos_y);
  const float kUpright = 1e-6f;  // a float's last digit
  if (cos_y < kUpright) return Rotation3D(std::atan2(-turn.r2_c3, turn.r2_c2), wy, 0);
  return Rotation3D(std::atan2(turn.r3_c2, turn.r3_c3), wy, std::atan2(turn.r2_c1, turn.r1_c1));
}
/// @throws std::runtime_error for a quaternion of 0.
inline void rotation3DFromQuaternion(const Quaternion& q, Rotation3D& turns) {
  turns = rotation3DFromRotation(Rotation::fromQuaternion(q.w, q.x, q.y, q.z));
}
inline void quaternionFromRotation3D(const Rotation3D& turns, Quaternion& q) {
  q = Quaternion::fromAngleAndAxisRotation(turns.wz, 0, 0, 1) *
      Quaternion::fromAngleAndAxisRotation(turns.wy, 0, 1, 0) *
      Quaternion::fromAngleAndAxisRotation(turns.wx, 1, 0, 0);
}
inline void quaternionPosition3DFromPosition6D(const Position6D& position, Quaternion& q,
                                               Position3D& place) {
  quaternionFromRotation3D(Rotation3D(position.wx, position.wy, position.wz), q);
  place = position3DFromPosition6D(position);
}

/// The inertia about the origin [kg m^2] of `mass` [kg] at `p` [m]: a 3x3 matrix, row by row.
inline void pointMassRotationalInertia(float mass, const Position3D& p,
                                       std::vector<float>& inertia) {
  inertia.clear();
  for (int i = 0; i < 9; ++i) {
    const float squares = i % 4 == 0 ? p.dotProduct(p) : 0;
    inertia.push_back(mass * (squares - p.at(i / 3) * p.at(i % 3)));
  }
}

}  // namespace Math
}  // namespace AL
