#pragma once

#include <utility>
#include <vector>

#include "core/robot_model.h"
#include "sim/body_motion.h"

namespace nao::sim {

/// The collision solids of one robot, as spheres about them in contiguous memory: who may touch
/// whom is found without looking at a solid.
class CollisionBody {
 public:
  struct Solid {
    int body;
    Shape shape;
  };
  struct Bound {  // a sphere that holds a solid
    Vec3 p_W;
    double radius;
  };

  /// The model must outlive this.
  explicit CollisionBody(const RobotModel& model);

  /// Follows the robot.
  void update(const std::vector<BodyMotion>& motion);

  std::size_t size() const { return solids_.size(); }
  const Solid& solid(std::size_t i) const { return solids_[i]; }
  const Bound& bound(std::size_t i) const { return bounds_[i]; }
  /// Holds all of the robot's solids.
  const Bound& whole() const { return whole_; }
  /// The pose in W of a solid's own frame.
  Pose calcPose(std::size_t i, const std::vector<BodyMotion>& motion) const;

  /// The pairs of solids that may ever touch: not those of one body, nor the model's no_collision.
  struct Pair {
    int a, b;
    double reach_squared;  // [m^2] of the sum of both radii
  };
  const std::vector<Pair>& pairs() const { return pairs_; }
  bool near(const Pair& pair) const {
    const Vec3& a = bounds_[static_cast<std::size_t>(pair.a)].p_W;
    const Vec3& b = bounds_[static_cast<std::size_t>(pair.b)].p_W;
    return (a - b).squaredNorm() < pair.reach_squared;
  }

 private:
  void findPairs(const RobotModel& model);

  std::vector<Solid> solids_;
  std::vector<Vec3> p_BS_;  // centre of each solid in its body
  std::vector<Bound> bounds_;
  std::vector<Pair> pairs_;
  Bound whole_{Vec3::Zero(), 0};
};

}  // namespace nao::sim
