#pragma once

#include <memory>
#include <vector>

#include "motion/body_solver.h"
#include "motion/cartesian.h"
#include "motion/phase.h"
#include "motion/trajectory.h"

namespace nao::motion {

/// Leads effectors through poses by inverse kinematics, one control cycle at a time. With a leg
/// goes the torso, held over the other sole as well as eleven motors can; with the torso both soles
/// stay where they are to each other.
class PoseFollower {
 public:
  PoseFollower(std::shared_ptr<const RobotModel> model, std::vector<PoseTrack> tracks,
               bool relative);

  /// Looks where everything is; `odometry` is where FRAME_WORLD has the robot frame.
  void begin(const JointArray<double>& angle, const Pose2& odometry);

  /// Moves the joints in `mine` towards where the effectors shall be at `time` [s]; slower than
  /// `fraction` of top speed. What is left of the way: [m], a radian as 0.3 m.
  double step(double time, double dt, double fraction, const JointSet& mine,
              JointArray<double>& angle);

  /// Where the effectors shall be at `time`, for a solver that moves the whole body.
  const std::vector<PlaceTask>& tasksAt(double time);

  double duration() const { return duration_; }  // [s]
  const JointSet& joints() const { return joints_; }
  void archive(Archive& archive);

 private:
  struct Course {
    Trajectory x, y, z, turn;  // turn: from 0, one more at every pose
    std::vector<Mat3> turns;   // at the start and at every pose
    Pose at(double time) const;
  };
  void beginTrack(const PoseTrack& track, const Chain& chain, const Pose2& odometry);
  Effector baseOf(const PoseTrack& track, const Pose2& odometry) const;
  void addHolds();
  bool has(Chain::Kind kind) const;
  const Effector& sole(Foot foot) const { return soles_[index(foot)]; }

  std::shared_ptr<const RobotModel> model_;
  std::vector<PoseTrack> tracks_;
  std::vector<Chain> chains_;
  bool relative_;
  JointSet joints_;
  std::array<Effector, 2> soles_;
  BodySolver solver_;
  std::vector<Course> courses_;
  std::vector<PlaceTask> tasks_;  // one per track, then what is held
  double duration_ = 0;
};

class WholeBody;

/// The phase of InterpolatePoses. With whole-body control on it asks that for its poses, and the
/// whole body follows. Ends with its last time, or up to a second later if the joints were too
/// slow and still come nearer.
class FollowPoses final : public Phase {
 public:
  explicit FollowPoses(PoseFollower follower) : follower_(std::move(follower)) {}
  void begin(Body& body) override;
  Progress advance(double dt, const JointSet& mine, Body& body) override;
  std::unique_ptr<Phase> clone() const override { return std::make_unique<FollowPoses>(*this); }
  void archive(Archive& archive) override;

 private:
  PoseFollower follower_;
  double elapsed_ = 0;
  double left_ = 0;  // [m] of the way, in the cycle before
};

/// The goals of setPosition and its like: pursued every cycle, given up when reached, when they
/// come no nearer, or when something else takes a joint.
class PoseGoals {
 public:
  void add(PoseFollower follower, double fraction);
  void release(const JointSet& joints);
  JointSet active() const;
  void advance(double dt, JointArray<double>& angle);
  void archive(Archive& archive);

 private:
  struct Goal {
    PoseFollower follower;
    double fraction = 1;
    double left = 0;  // [m]
  };
  std::vector<Goal> goals_;
};

}  // namespace nao::motion
