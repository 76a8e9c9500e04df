#pragma once

#include <vector>

#include "core/archive.h"
#include "core/robot_model.h"
#include "sim/body_plan.h"
#include "sim/external_force.h"
#include "sim/terrain.h"
#include "sim/tree_dynamics.h"

namespace nao::sim {

/// The points of one robot that can touch the ground and obstacles, linearly implicit. Per point,
/// with the depth z below a surface and x along it:
///   normal      f_n = max(0, k z - d v_n)
///   tangential  f_t = -k_t (x - anchor) - d_t x' while |f_t| <= mu f_n: it really sticks;
///               beyond that it slides with mu f_n against the motion, and the anchor follows.
///   restitution a surface that has some throws a point back that comes faster than kBounce: it
///               ends the step of the impact with -e times its speed (Newton). A spring with the
///               damping of Flores et al. (2011) has the same e, but takes tens of steps to show
///               it; the modes without an implicit step use that.
///   torsional   a point with a radius bears a torque about the normal of mu_t f_n at most, against
///               its spin.
/// A point that was sliding starts from there, with the normal force of the step before, so that
/// friction lags the load by one step. Points: four corners of each sole and the model's spheres;
/// each holds on to the ground and to the obstacle it is deepest in. Anchors are state.
class GroundContact {
 public:
  struct Force {  // of the ground on the robot, over the step solved last
    int body;
    int foot;      // index into RobotModel::feet, or -1
    Vec3 p_B;      // [m] where, in the body
    Vec3 f_W;      // [N]
    double depth;  // [m]
  };

  explicit GroundContact(const BodyPlan& plan);

  void setWet(const std::vector<WetPatch>& patches) { terrain_.setWet(patches); }

  /// Whether it has no point that could touch anything.
  bool isEmpty() const { return points_.empty(); }

  /// Nothing touches any more.
  void reset();
  void archive(Archive& archive);

  /// Starts a step of `h` [s]: finds the points that touch within it.
  void prepare(const std::vector<BodyMotion>& motion, const TreeDynamics& mass, double h);

  void addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs);

  /// After a solve: lets points slide that can not hold; once all agree on that and `may_open`,
  /// lets go of points that would pull. True if any changed.
  bool revise(const Eigen::VectorXd& du, bool may_open);

  /// Ends the step that revise() saw last: moves the anchors.
  void finish(const std::vector<BodyMotion>& motion);

  const std::vector<Force>& forces() const { return forces_; }

  /// Adds the forces at this very state, without a step; points hold where they held before. No
  /// torsional friction.
  void addSmooth(const std::vector<BodyMotion>& motion, std::vector<ExternalForce>& forces) const;
  /// Ends a step taken with addSmooth(): points that touch now, hold here; those that slide, move.
  void settle(const std::vector<BodyMotion>& motion);

  /// How high [m] the lowest of all points stands over the ground, along its normal.
  double lowestPoint(const std::vector<BodyMotion>& motion) const;
  /// How far up [m] the robot must go so that it stands on the obstacles it would be in; 0: none.
  double calcLift(const std::vector<BodyMotion>& motion) const;

 private:
  enum class Mode { Open, Stick, Slide, Brake };  // Brake: yields or comes to rest
  using Spatial = TreeDynamics::Spatial;
  struct Anchor {
    bool touching = false;
    bool sliding = false;
    int surface = Terrain::kGround;
    double load = 0;            // [N] normal force of the step before
    double approach = 0;        // [m/s] it came with
    Vec3 place = Vec3::Zero();  // [m] in W
  };
  struct Point {
    int body;
    int foot;
    Vec3 p_B;
    double radius;
  };
  struct Touch {
    std::size_t anchor;  // two by point: ground, obstacle
    std::size_t group;   // of its body
    Mode mode;
    const Material* material;
    Vec3 p_W;      // [m] the deepest of its sphere
    Vec3 r;        // [m] the same from the root's origin
    double depth;  // [m]
    Mat3 R;        // its frame in W: two tangents, the first along the sliding, and the normal
    Vec3 v;        // [m/s] in that frame
    Vec3 now;      // [N] at the start of the step, with the velocity carried on
    Vec3 change;   // [N s/m] their fall per unit of change of velocity
    Vec3 force;    // [N] over the step
    Vec3 after;    // [m/s] velocity at its end
    double spin, twist, twist_change;  // [rad/s], [N m], [N m s] about the normal
  };
  struct Group {  // the touches of one body, taken together
    int body = -1;
    TreeDynamics::SpatialMatrix stiffness;
    Spatial wrench, change;  // change: of the body's velocity
  };
  struct Smooth {
    Vec3 p_W, f_W;
    double depth, approach;
    bool touching, sliding;
  };
  void addFoot(const FootModel& foot, int index);
  Vec3 centerOf(const Point& point, const std::vector<BodyMotion>& motion) const;
  bool findObstacle(const Vec3& p_W, Terrain::Spot& spot) const;
  void meet(std::size_t anchor, const Terrain::Spot& spot, const Vec3& center_W,
            const BodyMotion& body);
  void open(std::size_t anchor, const Terrain::Spot& spot, const Vec3& p_W, const Vec3& v_W,
            double spin);
  std::size_t groupOf(int body);
  void add(const Touch& touch, Group& group) const;
  void begin(Touch& touch) const;
  void goOn(Touch& touch, const Anchor& anchor) const;
  void turnTo(Touch& touch, double x, double y) const;
  void stick(Touch& touch) const;
  void bounce(Touch& touch) const;
  void slide(Touch& touch, double load) const;
  void brake(Touch& touch) const;
  void twist(Touch& touch, double load) const;
  bool keepsFriction(Touch& touch) const;
  bool keepsTwist(Touch& touch, double spin_after) const;
  Smooth calcSmooth(std::size_t anchor, const Terrain::Spot& spot,
                    const std::vector<BodyMotion>& motion) const;
  template <class Visit>
  void visitSmooth(const std::vector<BodyMotion>& motion, const Visit& visit) const;

  Terrain terrain_;
  double h_ = 0;
  const TreeDynamics* mass_ = nullptr;
  std::vector<Point> points_;
  double reach_ = 0;             // [m] of all points from the root, with straight limbs
  std::vector<Anchor> anchors_;  // two by point: on the ground, on an obstacle
  std::vector<int> near_;        // obstacles, in this step
  std::vector<Touch> touches_;
  std::size_t touch_count_ = 0;  // touches_ keeps its memory
  std::vector<Group> groups_;
  std::size_t group_count_ = 0;
  std::vector<Force> forces_;
};

}  // namespace nao::sim
