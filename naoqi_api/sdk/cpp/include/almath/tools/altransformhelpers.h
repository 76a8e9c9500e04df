#pragma once

#include <almath/tools/almath.h>
#include <almath/tools/alreferences.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {
namespace Math {

inline Transform transformFromRotationPosition3D(const Rotation& turn, const float& x,
                                                 const float& y, const float& z) {
  Transform t(x, y, z);
  for (int i = 0; i < 9; ++i) t.at(i / 3, i % 3) = turn.at(i);
  return t;
}
inline Transform transformFromRotationPosition3D(const Rotation& turn, const Position3D& p) {
  return transformFromRotationPosition3D(turn, p.x, p.y, p.z);
}
inline Transform transformFromRotation(const Rotation& turn) {
  return transformFromRotationPosition3D(turn, 0, 0, 0);
}
inline void transformFromRotationInPlace(const Rotation& turn, Transform& t) {
  t = transformFromRotation(turn);
}
inline Transform transformFromRotation3D(const Rotation3D& turns) {
  return Transform::from3DRotation(turns.wx, turns.wy, turns.wz);
}
inline Transform transformFromPosition3D(const Position3D& p) { return Transform(p.x, p.y, p.z); }
inline void transformFromPosition3DInPlace(const Position3D& p, Transform& t) {
  t = transformFromPosition3D(p);
}
inline Transform transformFromPosition6D(const Position6D& p) {
  return Transform::fromPosition(p.x, p.y, p.z, p.wx, p.wy, p.wz);
}
inline Transform transformFromPose2D(const Pose2D& pose) {
  return Transform::fromPosition(pose.x, pose.y, 0, 0, 0, pose.theta);
}
inline void transformFromPose2DInPlace(const Pose2D& pose, Transform& t) {
  t = transformFromPose2D(pose);
}
/// Of any norm. @throws std::runtime_error for 0
inline Transform transformFromQuaternion(const Quaternion& q) {
  return transformFromRotation(Rotation::fromQuaternion(q.w, q.x, q.y, q.z));
}

/// By `angle` [rad] about the axis of that number, 1 to 3 for x to z, then shifted by `p` [m].
/// @throws std::runtime_error for another number.
inline Transform transformFromRotVec(const int axis, const float angle, const Position3D& p) {
  if (axis < 1 || axis > 3) {
    throw std::runtime_error("ALMath: expected an axis from 1 to 3, found " + std::to_string(axis));
  }
  const Transform turn = axis == 1   ? Transform::fromRotX(angle)
                         : axis == 2 ? Transform::fromRotY(angle)
                                     : Transform::fromRotZ(angle);
  return Transform(p.x, p.y, p.z) * turn;
}
inline void transformFromRotVecInPlace(const int axis, const float angle, const Position3D& p,
                                       Transform& t) {
  t = transformFromRotVec(axis, angle, p);
}
/// The turn alone.
inline Transform transformFromRotVec(const int& axis, const float& angle) {
  return transformFromRotVec(axis, angle, Position3D());
}
/// The shift alone.
inline Transform transformFromRotVec(const Position3D& p) { return transformFromPosition3D(p); }
inline void transformFromRotVecInPlace(const Position3D& p, Transform& t) {
  t = transformFromPosition3D(p);
}

inline Rotation rotationFromTransform(const Transform& t) {
  Rotation turn;
  for (int i = 0; i < 9; ++i) turn.at(i) = t.at(i / 3, i % 3);
  return turn;
}
inline void rotationFromTransformInPlace(const Transform& t, Rotation& turn) {
  turn = rotationFromTransform(t);
}
/// As rotation3DFromRotation().
inline Rotation3D rotation3DFromTransform(const Transform& t) {
  return rotation3DFromRotation(rotationFromTransform(t));
}
inline Position3D position3DFromTransform(const Transform& t) {
  return Position3D(t.r1_c4, t.r2_c4, t.r3_c4);
}
inline void position3DFromTransformInPlace(const Transform& t, Position3D& p) {
  p = position3DFromTransform(t);
}
inline Position2D position2DFromTransform(const Transform& t) {
  return Position2D(t.r1_c4, t.r2_c4);
}
inline void position2DFromTransformInPlace(const Transform& t, Position2D& p) {
  p = position2DFromTransform(t);
}
inline Position6D position6DFromTransform(const Transform& t) {
  const Rotation3D turns = rotation3DFromTransform(t);
  return Position6D(t.r1_c4, t.r2_c4, t.r3_c4, turns.wx, turns.wy, turns.wz);
}
inline void position6DFromTransformInPlace(const Transform& t, Position6D& p) {
  p = position6DFromTransform(t);
}
/// Its place on the floor, and the heading of its axis x.
inline Pose2D pose2DFromTransform(const Transform& t) {
  return Pose2D(t.r1_c4, t.r2_c4, std::atan2(t.r2_c1, t.r1_c1));
}
inline void pose2DFromTransformInPlace(const Transform& t, Pose2D& pose) {
  pose = pose2DFromTransform(t);
}
/// With w of 0 or more.
inline Quaternion quaternionFromTransform(const Transform& t) {
  Quaternion q;
  quaternionFromRotation3D(rotation3DFromTransform(t), q);
  return q.w < 0 ? q * -1.0f : q;
}

/// `b` as seen from `a`.
inline Position6D transformDifferenceInPosition6D(const Transform& a, const Transform& b) {
  return position6DFromTransform(a.diff(b));
}
/// What leads from frame `b` to frame `c`, both seen from a frame A and the answer, too: the shift
/// of the origin [m], and the axis of the turn times its angle [rad].
USARNAOQI_SDK_API Position6D position6DFromTransformDiff(const Transform& b, const Transform& c);
inline void position6DFromTransformDiffInPlace(const Transform& b, const Transform& c,
                                               Position6D& result) {
  result = position6DFromTransformDiff(b, c);
}

/// The steady motion, in the moving frame, that leads to `t` in one second; its angle below pi.
USARNAOQI_SDK_API Velocity6D transformLogarithm(const Transform& t);
inline void transformLogarithmInPlace(const Transform& t, Velocity6D& velocity) {
  velocity = transformLogarithm(t);
}
/// Where a steady motion has led after one second.
USARNAOQI_SDK_API Transform velocityExponential(const Velocity6D& velocity);
/// On the steady motion from `a` to `b`: 0 is a, 1 is b.
USARNAOQI_SDK_API Transform transformMean(const Transform& a, const Transform& b,
                                          const float& share = 0.5f);
inline void transformMeanInPlace(const Transform& a, const Transform& b, const float& share,
                                 Transform& mean) {
  mean = transformMean(a, b, share);
}

}  // namespace Math
}  // namespace AL
