#pragma once

#include <vector>

#include "core/world_model.h"
#include "sim/ball_body.h"
#include "sim/contact_report.h"
#include "sim/robot_body.h"

namespace nao::sim {

/// How two surfaces push each other.
struct ContactLaw {
  double stiffness = 0;           // [N/m]; 0: rigid
  double damping = 0;             // [N s/m]
  double friction = 0;            // Coulomb coefficient
  double torsional_friction = 0;  // [m] torque about the normal per normal force
  double restitution = 0;         // part of the approach speed that comes back
};

/// The impulses between movers (robots and balls) and what they touch, over one step, found
/// together. Per contact, with v' the speed of parting and f the force at the end of the step:
///   soft    f = max(0, k (depth - h v') - d v'), which alone against a mobility W is
///           f = max(0, k depth - (d + h k) v) / (1 + h (d + h k) W)
///   rigid   f >= 0 and v' >= gap / h, or v' >= -e v after an approach v faster than kBounce
///   friction: stops the sliding, or mu f against it; torsional friction likewise about the
///   normal, of balls alone.
/// Contacts that share a mover know of each other: projected Gauss-Seidel over M^-1 J^T (Catto,
/// Iterative Dynamics with Temporal Coherence, 2005), kSweeps times in the order they were added.
/// M is a robot's with limp joints, which move more than driven ones: f is never too large for the
/// implicit step that follows. Both sides get exactly opposite impulses at one point.
class ContactSolver {
 public:
  struct Side {
    enum class Kind { Fixed, Robot, Ball };
    Kind kind = Kind::Fixed;
    int index = -1;
    int body = 0;
  };
  struct Contact {
    Side a, b;
    Vec3 p_W, n_W;  // [m]; unit, from b towards a
    double depth;   // [m] negative: a gap that may close within the step
    ContactLaw law;
    Vec3 f_W = Vec3::Zero();  // [N] on a, -f_W on b: after solve()
  };

  void clear() { contacts_.clear(); }
  void add(const Contact& contact) { contacts_.push_back(contact); }

  /// Finds the forces over a step of `h` [s]; balls already have the velocity they would have
  /// without contacts, and get the one they have with them. `models` of the balls.
  void solve(const std::vector<RobotBody*>& robots, const std::vector<Ball>& models,
             std::vector<BallState>& balls, double h);

  const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  struct Mover {
    bool active = false;
    Eigen::VectorXd u;  // generalized velocity
  };
  struct Lever {  // how a row acts on one mover
    Mover* mover = nullptr;
    Eigen::VectorXd push, response;  // J^T, and M^-1 J^T
  };
  struct Row {
    Lever a, b;
    double mobility = 0;  // W
    double impulse = 0;   // [N s] or [N m s]
  };
  struct Rows {
    Row normal, first, second, twist;
    Vec3 first_W, second_W;
    double softness = 0;  // of the normal: v' + softness impulse + bias >= 0
    double bias = 0;
    double free_speed = 0;
  };

  void prepare(const Contact& contact, Rows& rows);
  void aim(const Contact& contact, Rows& rows) const;
  void reach(const Contact& contact, const Vec3& direction_W, bool turning, Row& row);
  void reachSide(const Side& side, const Vec3& p_W, const Vec3& direction_W, bool turning,
                 double sign, Lever& lever);
  Mover& moverOf(const Side& side);
  static double speed(const Row& row);
  static double stopping(const Row& row);
  static void apply(Row& row, double impulse);
  static void sweep(const Contact& contact, Rows& rows);

  std::vector<Contact> contacts_;
  std::vector<Rows> rows_;  // keeps its memory
  std::vector<Mover> robot_movers_, ball_movers_;
  const std::vector<RobotBody*>* robots_ = nullptr;
  const std::vector<Ball>* models_ = nullptr;
  std::vector<BallState>* balls_ = nullptr;
  double h_ = 0;
};

}  // namespace nao::sim
