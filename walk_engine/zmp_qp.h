#pragma once

#include <array>
#include <vector>

#include <Eigen/Dense>

#include "core/archive.h"
#include "core/qp_solver.h"

namespace nao::walk {

/// Centre of mass of the linear inverted pendulum, both axes: position [m], velocity, acceleration.
struct ComState {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  Eigen::Vector3d y = Eigen::Vector3d::Zero();

  void archive(Archive& archive) {
    archive.numbers(x);
    archive.numbers(y);
  }
};

/// One edge of a support polygon: the zero moment point z keeps normal . (z - share d) <= offset,
/// where d is how far landing `step` is moved from its plan.
struct SupportEdge {
  Eigen::Vector2d normal = Eigen::Vector2d::UnitX();  // unit, outwards
  double offset = 0;                                  // [m]
  int step = -1;                                      // -1: of feet that stand
  double share = 0;                                   // of the edge that moves with it
};

/// What is asked of the zero moment point at one instant of the preview.
struct ZmpSample {
  double dt = 0;                                        // [s] since the instant before
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();  // [m]
  int step = -1;                                        // landing that the reference moves with
  double share = 0;                                     // how much
  std::vector<SupportEdge> support;
};

/// What is asked of the capture point at the end of the preview.
struct CaptureGoal {
  Eigen::Vector2d reference = Eigen::Vector2d::Zero();  // [m]
  int step = -1;                                        // landing that the reference moves with
  std::vector<SupportEdge> support;                     // it ends inside
};

/// How much further a landing may be moved, in its own frame's directions.
struct LandingRange {
  Eigen::Vector2d moved = Eigen::Vector2d::Zero();     // [m] so far, from where it was planned
  Eigen::Vector2d forward = Eigen::Vector2d::UnitX();  // unit vector of the foot's x
  Eigen::Vector2d low = Eigen::Vector2d::Zero();       // [m] along it and to its left
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
};

/// The gait as a quadratic program (Wieber, Trajectory free linear model predictive control for
/// stable walking, 2006; Herdt et al., Online walking motion generation with automatic footstep
/// placement, 2010): jerks of the centre of mass, constant between the instants of the preview, and
/// displacements of the next landings, that minimise
///   sum |z - reference|^2 + r sum jerk^2 dt + w_d sum |d|^2 + w_c |xi_end - reference_end|^2
/// with the zero moment point z = c - (h/g) c'' inside the support polygon at every instant, and
/// the capture point xi = c + c' sqrt(h/g) at the end where the next step can still catch it. Units
/// m and s.
class ZmpQp {
 public:
  static constexpr int kLandings = 2;  // at most, that may be moved

  /// `com_height` [m] over `gravity` [m/s^2].
  ZmpQp(double com_height, double gravity);

  struct Plan {
    bool feasible = false;  // else the polygons were widened until they could be met
    Eigen::Vector2d jerk;   // [m/s^3] until the first instant
    std::array<Eigen::Vector2d, kLandings> moved;  // [m] of the landings
    int iterations = 0;
  };
  Plan solve(const ComState& com, const std::vector<ZmpSample>& samples, const CaptureGoal& end,
             const std::vector<LandingRange>& landings);

  /// Of the pendulum [1/s]: its capture point runs away from the zero moment point as e^(rate t).
  double rate() const { return 1 / decay_; }

  const QpProblem& problem() const { return problem_; }  // solved last

  /// Lists what the next solve() remembers of the last.
  void archive(Archive& archive) { solver_.archive(archive); }

  /// `com` after `dt` [s] of this jerk.
  static ComState carryOn(const ComState& com, const Eigen::Vector2d& jerk, double dt);
  Eigen::Vector2d calcZmp(const ComState& com) const;           // [m]
  Eigen::Vector2d calcCapturePoint(const ComState& com) const;  // [m]

 private:
  void layOut(const std::vector<ZmpSample>& samples);
  void addCost(const ComState& com, const std::vector<ZmpSample>& samples, const CaptureGoal& end,
               const std::vector<LandingRange>& landings);
  void addEdges(const ComState& com, const std::vector<ZmpSample>& samples, const CaptureGoal& end);
  void addEdge(const SupportEdge& edge, const Eigen::Vector2d& free,
               const Eigen::RowVectorXd& jerk);
  void addLandings(const std::vector<LandingRange>& landings);
  int rowOf(int step, int axis) const { return 2 * instants_ + 2 * step + axis; }

  double lag_;    // [s^2] h / g
  double decay_;  // [s] sqrt(h / g)
  int instants_ = 0;
  std::vector<double> times_;                // dt of each instant, that the matrices below are for
  Eigen::MatrixXd zmp_state_;                // z at each instant from the state now
  Eigen::MatrixXd zmp_jerk_;                 // and from the jerks
  Eigen::RowVectorXd end_state_, end_jerk_;  // the capture point at the end, the same way
  Eigen::MatrixXd hessian_;                  // of one axis, without landings
  QpProblem problem_;
  QpSolver solver_;
  int rows_ = 0;
};

}  // namespace nao::walk
