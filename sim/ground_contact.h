#pragma once

#include <vector>

#include "core/archive.h"
#include "core/robot_model.h"
#include "core/world_model.h"
#include "sim/external_force.h"
#include "sim/tree_dynamics.h"

namespace nao::sim {

/// The points of one robot that can touch the ground z = 0, linearly implicit. Per point:
///   normal      f_n = max(0, -k z - d z')
///   tangential  f_t = -k_t (x - anchor) - d_t x' while |f_t| <= mu f_n: it really sticks;
///               beyond that it slides with mu f_n against the motion, and the anchor follows.
/// A point that was sliding starts from there, with the normal force of the step before, so that
/// friction lags the load by one step. Points: four corners of each sole and the model's spheres.
/// The anchors are state: they belong into every snapshot.
class GroundContact {
 public:
  struct Anchor {
    bool touching = false;
    bool sliding = false;
    double load = 0;                                  // [N] normal force of the step before
    Eigen::Vector2d place = Eigen::Vector2d::Zero();  // [m] in W
  };
  struct Force {  // of the ground on the robot, over the step solved last
    int body;
    int foot;      // index into RobotModel::feet, or -1
    Vec3 p_B;      // [m] where, in the body
    Vec3 f_W;      // [N]
    double depth;  // [m]
  };

  GroundContact(const RobotModel& model, const Material& material);

  /// Nothing touches any more.
  void reset();
  void archive(Archive& archive);

  /// Starts a step of `h` [s]: finds the points that touch within it.
  void prepare(const std::vector<BodyMotion>& motion, const TreeDynamics& mass, double h);

  void addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const;

  /// After a solve: lets points slide that can not hold; once all agree on that and `may_open`,
  /// lets go of points that would pull. True if any changed.
  bool revise(const Eigen::VectorXd& du, bool may_open);

  /// Ends the step: moves the anchors.
  void finish(const Eigen::VectorXd& du);

  const std::vector<Force>& forces() const { return forces_; }

  /// Adds the forces at this very state, without a step; points hold where they held before.
  void addSmooth(const std::vector<BodyMotion>& motion, std::vector<ExternalForce>& forces) const;
  /// Ends a step taken with addSmooth(): points that touch now, hold here; those that slide, move.
  void settle(const std::vector<BodyMotion>& motion);

  /// The height [m] of the lowest of all points.
  double lowestPoint(const std::vector<BodyMotion>& motion) const;

 private:
  enum class Mode { Open, Stick, Slide, Brake };  // Brake: slides and comes to rest
  struct Point {
    int body;
    int foot;
    Vec3 p_B;
    double radius;
  };
  struct Touch {
    std::size_t point;
    Mode mode;
    Vec3 p_W;                   // [m] lowest point of the sphere
    Eigen::Vector2d direction;  // x axis of the frame of the rest, in W: along the sliding
    Vec3 v;                     // [m/s]
    Vec3 now;                   // [N] at the start of the step, with the velocity carried on
    Vec3 change;                // [N s/m] their fall per unit of change of velocity
    Vec3 force;                 // [N] over the step
    TreeDynamics::PointJacobian jacobian;
  };
  struct Smooth {
    Vec3 p_W, f_W;
    bool touching, sliding;
  };
  Smooth calcSmooth(std::size_t point, const std::vector<BodyMotion>& motion) const;
  void addFoot(const FootModel& foot, int index);
  void open(std::size_t point, const Vec3& p_W, const Vec3& v_W);
  void turnTo(Touch& touch, const Eigen::Vector2d& direction) const;
  void stick(Touch& touch) const;
  void slide(Touch& touch, double load) const;
  void brake(Touch& touch) const;
  bool keepsFriction(Touch& touch, double speed_after) const;
  Vec3 velocityChange(const Touch& touch, const Eigen::VectorXd& du) const;
  static Vec3 toWorld(const Touch& touch, const Vec3& v);

  Material material_;
  double h_ = 0;
  const TreeDynamics* mass_ = nullptr;
  std::vector<Point> points_;
  std::vector<Anchor> anchors_;  // by point
  std::vector<Touch> touches_;
  std::size_t touch_count_ = 0;  // touches_ keeps its memory
  std::vector<Force> forces_;
};

}  // namespace nao::sim
