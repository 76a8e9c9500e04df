#pragma once

#include <vector>

#include "core/robot_model.h"
#include "sim/body_motion.h"
#include "sim/tree_matrix.h"

namespace nao::sim {

/// Kinematics and dynamics of a robot's tree in contiguous arrays, held against Simbody by tests.
/// Velocities and forces of all bodies are taken about the root's origin along the axes of W, so
/// that they add up without any change of frame:
///   poses and velocities root to leaves, bias by recursive Newton-Euler, inertia by composite
///   rigid bodies (Featherstone, Rigid Body Dynamics Algorithms, 2008, sections 5.3 and 6.2).
/// Hinges that share a motor move freely here: tying them together is the stepper's work.
class TreeDynamics {
 public:
  explicit TreeDynamics(const RobotModel& model);

  int speedCount() const { return static_cast<int>(parents_.size()); }
  int rootSpeedCount() const { return root_speeds_; }  // 6, or 0 with a fixed base
  int rootPositionCount() const { return root_speeds_ > 0 ? 7 : 0; }
  /// Ancestors of each speed: the layout of TreeState::u as a tree.
  const std::vector<int>& parents() const { return parents_; }

  /// Upright above the origin, all angles 0, at rest.
  TreeState zeroState() const;

  /// Takes `state` over for the calls below.
  void setState(const TreeState& state);

  /// Where the bodies are and how they move.
  const std::vector<BodyMotion>& motion() const { return motion_; }

  /// Slows every body by a = -linear v, angular' = -angular w [1/s]: part of calcBias().
  void setDamping(double linear, double angular);

  /// The generalized forces [N m, N] that would keep u constant under `gravity` [m/s^2] along -z.
  void calcBias(double gravity, Eigen::VectorXd& bias);

  /// Writes M into `matrix`, whose tree must be parents().
  void calcMassMatrix(TreeMatrix& matrix);

  /// The speed that moves `body` last: of its own hinge, or of the root.
  int leafOf(int body) const { return body == 0 ? root_speeds_ - 1 : root_speeds_ + body - 1; }

  /// The velocity of point `p_W` of a body along x, y, z of W per unit of each speed that moves it,
  /// from the root to leafOf(body): the rows that TreeMatrix takes.
  static constexpr int kMaxDepth = 64;
  struct PointJacobian {
    int leaf = -1;
    int count = 0;
    int speed[kMaxDepth];  // whose entry this is
    double row[3][kMaxDepth];
  };
  void calcPointJacobian(int body, const Vec3& p_W, PointJacobian& jacobian) const;

  /// What a body as a whole does and bears, about the root's origin along the axes of W: its
  /// velocity (angular, linear), a wrench (moment, force), and how a wrench changes with velocity.
  /// The speed of a point r from the root's origin along d is (r x d, d) . velocity.
  using Spatial = Eigen::Matrix<double, 6, 1>;
  using SpatialMatrix = Eigen::Matrix<double, 6, 6>;
  const Vec3& rootOrigin() const { return motion_[0].p_WB; }
  Spatial calcBodyVelocity(const Eigen::VectorXd& u, int body) const;
  /// Adds J^T w to `rhs`, and J^T K J for a symmetric K to `matrix`; J of calcBodyVelocity().
  void addBodyWrench(int body, const Spatial& w, Eigen::VectorXd& rhs) const;
  void addBodyStiffness(int body, const SpatialMatrix& K, TreeMatrix& matrix) const;

  double totalMass() const { return mass_; }

 private:
  // What is fixed about a body.
  struct Link {
    enum class Axis { X, Y, Z, Any };
    int parent;
    Axis axis;
    bool aligned;  // with its parent at hinge angle 0
    Mat3 R_PB;
    Vec3 p_PB, axis_B;
    double mass;
    Vec3 com_B;
    Mat3 inertia_B;
  };
  // Mass, moment of mass [kg m] and inertia of one or more bodies about the root's origin.
  struct SpatialInertia {
    double mass;
    Vec3 moment;
    double inertia[6];  // xx yy zz xy xz yz
  };
  // What changes with the state, about the root's origin, axes of W.
  struct Moving {
    Vec3 arm;     // to the body's origin
    Vec3 axis;    // of its hinge
    Vec3 lever;   // velocity at the root's origin per unit of hinge rate
    Vec3 com;     // to the centre of mass
    double rate;  // of the hinge
    SpatialInertia own, composite;
    double central[6];         // inertia about the centre of mass: xx yy zz xy xz yz
    Vec3 alpha, acceleration;  // with u' = 0
    Vec3 force, moment;        // of the subtree
  };
  static Link makeLink(const Body& body);
  void placeChild(std::size_t i, double angle, double rate);
  void takeInertia(std::size_t i);
  void addColumn(TreeMatrix& matrix, std::size_t body) const;
  void addRoot(TreeMatrix& matrix) const;

  int root_speeds_;
  double mass_ = 0;
  double linear_damping_ = 0;
  double angular_damping_ = 0;
  std::vector<Link> links_;
  std::vector<int> parents_;
  std::vector<Moving> moving_;
  std::vector<BodyMotion> motion_;
};

}  // namespace nao::sim
