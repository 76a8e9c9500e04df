#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/qp_solver.h"
#include "motion/joint_set.h"
#include "motion/kinematics.h"

namespace nao::motion {

/// NaoQi's axis masks: bits for x, y, z and the turns about them.
inline constexpr int kMaskPosition = 7;
inline constexpr int kMaskRotation = 56;
inline constexpr int kMaskAll = 63;
/// What a sole on the floor keeps: its height and its slope.
inline constexpr int kMaskPlane = 4 | 8 | 16;

/// Where a place F shall be, as seen from another place B of the same body.
struct PlaceTask {
  Effector place;                // F
  Effector base;                 // B
  Pose X_BF = Pose::Identity();  // wanted
  int mask = kMaskAll;           // the axes of B that count
  double weight = 1;             // of a metre
  double radian = 0.3;           // [m] what a radian counts as: half of a Nao's height
  bool exact = false;            // an equality of the QP, its weight does not count
};

/// Where the centre of mass shall be, in the plane z = 0 of a frame fixed to a body.
struct ComTask {
  Effector floor;
  std::optional<Eigen::Vector2d> target;  // [m]
  std::vector<Eigen::Vector2d> inside;    // [m] corners, counter-clockwise; empty: anywhere
};

/// Generalized inverse kinematics, one control cycle at a time, as a QP over the joints' steps dq:
///   minimize  sum w |J dq - e|^2 + sum w_j (q_j + dq_j - wish_j)^2 + damping |dq|^2
///   subject to J dq = e of exact tasks, joint ranges (those that depend on another joint too), the
///   centre of mass inside its polygon,
/// and the solution scaled as a whole so that no joint is faster than allowed. Everything is seen
/// from a place of the body itself (the torso, a supporting sole): the body needs no place in the
/// world. dq = 0 is always allowed: what can not be met is met as far as it can.
/// (Task-function approach of Siciliano and Slotine 1991, as a QP as in Kanoun, Lamiraux and Wieber
/// 2011.)
class BodySolver {
 public:
  struct Demand {
    JointSet joints;  // that may move
    std::vector<PlaceTask> places;
    std::optional<ComTask> com;
    JointArray<double> wish;  // [rad] and how much each counts; size 0: no wishes
    JointArray<double> wish_weight;
    double fraction = 1;  // of every joint's top speed
    double dt = 0;        // [s] of the cycle
  };

  explicit BodySolver(std::shared_ptr<const RobotModel> model);

  /// One cycle: moves `angle` towards what is demanded.
  void step(const Demand& demand, JointArray<double>& angle);

  /// How far the places are from where they shall be, [m] with a radian as 0.3 m: the largest.
  double calcError(const Demand& demand, const JointArray<double>& angle);

  /// The body at the angles last looked at.
  Kinematics& body() { return body_; }
  const Kinematics& body() const { return body_; }

 private:
  using Twist = Eigen::Matrix<double, 6, Eigen::Dynamic>;  // linear at T's origin, then angular
  using Vec6 = Eigen::Matrix<double, 6, 1>;

  Twist calcTwist(int body) const;
  Twist calcTwist(const PlaceTask& task) const;  // of F as seen from B, in the axes of B
  Vec6 calcError(const PlaceTask& task) const;
  Eigen::Matrix2Xd calcComJacobian(const ComTask& com, Eigen::Vector2d& place) const;
  void correct(const Demand& demand, JointArray<double>& angle);
  void build(const Demand& demand, const JointArray<double>& angle, bool exact);
  void addPlace(const PlaceTask& task, bool exact);
  void addCom(const Demand& demand, bool recover);
  void addRanges(const JointArray<double>& angle);
  void addCoupled(const CoupledLimit& limit, const JointArray<double>& angle);
  void addRow(const Eigen::RowVectorXd& row, double bound);
  void finishRows(int equalities);

  std::shared_ptr<const RobotModel> model_;
  Kinematics body_;
  QpSolver solver_;
  QpProblem problem_;
  std::vector<std::size_t> columns_;  // joints by column
  std::vector<int> column_of_;        // by joint; -1: does not move
  std::vector<Eigen::RowVectorXd> rows_;
  std::vector<double> bounds_;
};

}  // namespace nao::motion
