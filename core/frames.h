#pragma once

#include <Eigen/Geometry>

namespace nao {

// Frames, all right-handed, metres:
//   W  world: origin on the ground at the centre of the field, x towards the opponent goal, z up.
//   R  robot: between the soles, on the ground, x forward, z up (NaoQi's FRAME_ROBOT).
//   T  torso: NaoQi's torso point, x forward, y left, z up (FRAME_TORSO).
//   Ls, Rs  soles: below each ankle on the bottom of the foot, axes of the foot.
//   H  head (HeadPitch link).   C camera: x along the line of sight, y left, z up.
//   B  any body: its joint's origin; in the zero pose every body's axes are the torso's.
// Monogram notation: X_WT is the pose of T in W, p_TH_W the position from T to H expressed in W.

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Pose = Eigen::Isometry3d;

/// A place on the floor: x and y [m], heading about the vertical [rad].
struct Pose2 {
  double x = 0;      // [m]
  double y = 0;      // [m]
  double theta = 0;  // [rad]
};

/// `angle` [rad] moved into (-pi, pi].
double wrapAngle(double angle);

/// The place `relative` (given in the frame of `base`) in the frame `base` itself is given in.
Pose2 compose(const Pose2& base, const Pose2& relative);

/// The place `target` as seen from `base`; both given in one frame.
Pose2 relativeTo(const Pose2& base, const Pose2& target);

/// Rotation about x by roll, then y by pitch, then z by yaw: R = Rz Ry Rx (URDF's and NaoQi's).
Mat3 rotationFromRpy(double roll, double pitch, double yaw);

/// The roll, pitch, yaw of rotationFromRpy that give `rotation`.
Vec3 rpyOf(const Mat3& rotation);

/// A translation without rotation.
Pose translation(const Vec3& p);

}  // namespace nao
