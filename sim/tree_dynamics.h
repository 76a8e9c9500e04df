#pragma once

#include <vector>

#include "core/robot_model.h"
#include "sim/multibody.h"
#include "sim/tree_matrix.h"

namespace nao::sim {

/// The joint-space inertia of a tree by the composite rigid body algorithm (Featherstone 2008,
/// section 6.2), with every quantity about the root's origin along the axes of W: composite
/// inertias then add up without any change of frame. Also answers how bodies move with u.
class TreeDynamics {
 public:
  explicit TreeDynamics(const RobotModel& model);

  /// Ancestors of each speed: the layout of TreeState::u as a tree.
  const std::vector<int>& parents() const { return parents_; }

  /// Takes over where the bodies are.
  void setMotion(const std::vector<BodyMotion>& motion);

  /// Writes M into `matrix`, whose tree must be parents().
  void calc(TreeMatrix& matrix) const;

  /// Adds to `bias` what holds every body up against `gravity` [m/s^2] along -z. After calc().
  void addWeight(double gravity, Eigen::VectorXd& bias) const;

  /// The speed that moves `body` last: of its own hinge, or of the root.
  int leafOf(int body) const { return body == 0 ? root_speeds_ - 1 : root_speeds_ + body - 1; }

  /// The velocity of point `p_W` of a body along x, y, z of W per unit of each speed, from the
  /// body's leafOf() up to the root: jacobian[axis][k]. Returns the number of entries.
  static constexpr int kMaxDepth = 64;
  struct PointJacobian {
    int leaf = -1;
    int count = 0;
    double row[3][kMaxDepth];
  };
  void calcPointJacobian(int body, const Vec3& p_W, PointJacobian& jacobian) const;

 private:
  struct SpatialInertia {  // about the root's origin, axes of W
    double mass = 0;
    Vec3 moment = Vec3::Zero();  // mass times centre of mass
    Mat3 inertia = Mat3::Zero();
  };
  SpatialInertia inertiaOf(std::size_t body) const;
  void addJoint(TreeMatrix& matrix, int speed, const SpatialInertia& composite) const;
  void addRoot(TreeMatrix& matrix, const SpatialInertia& composite) const;

  const RobotModel& model_;
  int root_speeds_;
  std::vector<int> parents_;
  const std::vector<BodyMotion>* motion_ = nullptr;
  std::vector<Vec3> axes_W_;  // by body, of its hinge
  std::vector<Vec3> arms_W_;  // by body, from the root's origin to the hinge
  mutable std::vector<SpatialInertia> composites_;
};

}  // namespace nao::sim
