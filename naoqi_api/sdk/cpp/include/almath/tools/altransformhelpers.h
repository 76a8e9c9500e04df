#pragma once

#include <algorithm>

#include <almath/tools/almath.h>

namespace AL {
namespace Math {

inline Transform transformFromRotX(float angle) { return Transform::fromRotX(angle); }
inline Transform transformFromRotY(float angle) { return Transform::fromRotY(angle); }
inline Transform transformFromRotZ(float angle) { return Transform::fromRotZ(angle); }
inline Transform transformFrom3DRotation(float wx, float wy, float wz) {
  return Transform::from3DRotation(wx, wy, wz);
}
inline Transform transformFromRotation3D(const Rotation3D& turns) {
  return Transform::from3DRotation(turns.wx, turns.wy, turns.wz);
}
inline Transform transformFromPosition(float x, float y, float z) { return Transform(x, y, z); }
inline Transform transformFromPosition(float x, float y, float z, float wx, float wy, float wz) {
  return Transform::fromPosition(x, y, z, wx, wy, wz);
}
inline Transform transformFromPosition3D(const Position3D& p) { return Transform(p.x, p.y, p.z); }
inline Transform transformFromPosition6D(const Position6D& p) {
  return Transform::fromPosition(p.x, p.y, p.z, p.wx, p.wy, p.wz);
}
inline Transform transformFromPose2D(const Pose2D& pose) {
  return Transform::fromPosition(pose.x, pose.y, 0, 0, 0, pose.theta);
}

inline Position3D position3DFromTransform(const Transform& t) {
  return Position3D(t.r1_c4, t.r2_c4, t.r3_c4);
}
/// The turns that from3DRotation() makes it of; wy within [-pi/2, pi/2].
inline Rotation3D rotation3DFromTransform(const Transform& t) {
  const float cos_y = std::sqrt(t.r1_c1 * t.r1_c1 + t.r2_c1 * t.r2_c1);
  const float wy = std::atan2(-t.r3_c1, cos_y);
  const float kUpright = 1e-6f;  // x and z then turn about the same axis
  if (cos_y < kUpright) return Rotation3D(std::atan2(-t.r2_c3, t.r2_c2), wy, 0);
  return Rotation3D(std::atan2(t.r3_c2, t.r3_c3), wy, std::atan2(t.r2_c1, t.r1_c1));
}
inline Position6D position6DFromTransform(const Transform& t) {
  const Rotation3D turns = rotation3DFromTransform(t);
  return Position6D(t.r1_c4, t.r2_c4, t.r3_c4, turns.wx, turns.wy, turns.wz);
}
inline Pose2D pose2DFromTransform(const Transform& t) {
  return Pose2D(t.r1_c4, t.r2_c4, std::atan2(t.r2_c1, t.r1_c1));
}
/// `b` as seen from `a`.
inline Position6D transformDifferenceInPosition6D(const Transform& a, const Transform& b) {
  return position6DFromTransform(a.diff(b));
}

inline Transform transformFromQuaternion(const Quaternion& q) {
  Transform t;
  t.r1_c1 = 1 - 2 * (q.y * q.y + q.z * q.z);
  t.r1_c2 = 2 * (q.x * q.y - q.w * q.z);
  t.r1_c3 = 2 * (q.x * q.z + q.w * q.y);
  t.r2_c1 = 2 * (q.x * q.y + q.w * q.z);
  t.r2_c2 = 1 - 2 * (q.x * q.x + q.z * q.z);
  t.r2_c3 = 2 * (q.y * q.z - q.w * q.x);
  t.r3_c1 = 2 * (q.x * q.z - q.w * q.y);
  t.r3_c2 = 2 * (q.y * q.z + q.w * q.x);
  t.r3_c3 = 1 - 2 * (q.x * q.x + q.y * q.y);
  return t;
}
/// With w of 0 or more.
inline Quaternion quaternionFromTransform(const Transform& t) {
  const Rotation3D turns = rotation3DFromTransform(t);
  Quaternion q = Quaternion::fromAngleAndAxisRotation(turns.wz, 0, 0, 1) *
                 Quaternion::fromAngleAndAxisRotation(turns.wy, 0, 1, 0) *
                 Quaternion::fromAngleAndAxisRotation(turns.wx, 1, 0, 0);
  if (q.w < 0) q = Quaternion(-q.w, -q.x, -q.y, -q.z);
  return q;
}

}  // namespace Math
}  // namespace AL
