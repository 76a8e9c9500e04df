#pragma once

#include <Eigen/Dense>

#include "core/frames.h"

namespace nao::sim {

/// Where a tree of bodies is and how it moves; a plain value.
///   q: root's quaternion w x y z, root's position [m] in W, then one angle [rad] per coordinate
///   u: root's angular velocity [rad/s], its velocity [m/s], both in W, then the rates [rad/s]
/// A robot with a fixed base has the coordinates alone.
struct TreeState {
  Eigen::VectorXd q;
  Eigen::VectorXd u;
};

/// Motion of every body in W, for one TreeState.
struct BodyMotion {
  Mat3 R_WB = Mat3::Identity();
  Vec3 p_WB = Vec3::Zero();  // [m] the body's origin
  Vec3 w_WB = Vec3::Zero();  // [rad/s]
  Vec3 v_WB = Vec3::Zero();  // [m/s] of the origin
};

}  // namespace nao::sim
