#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/archive.h"
#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "motion/kinematics.h"

namespace nao::walk {

/// One cycle of a planned motion. O is a frame fixed to the floor, z up.
struct PlannedPose {
  JointArray<double> angle;                // [rad]
  std::vector<Pose> X_OB;                  // by body
  std::array<bool, 2> stands{true, true};  // by Foot: on the floor
};

/// The command that makes the leg servos follow a planned motion. A servo with proportional gain kp
/// and damping kd gives the torque tau only when its command is ahead of its angle:
///   command = q + (kd / kp + half a cycle) dq/dt + tau / kp + play / 2 * sign(tau),
/// the last for a gear whose play the robot's file documents: its motor pushes from one end of it.
/// The sign is a smooth one, for a tau that changes it. tau comes from the planned motion by
/// Newton's law: the ground gives all bodies their weight and acceleration, each standing foot its
/// part, and each hinge what the links below it need. Links count as point masses. Central
/// differences make it one cycle late.
class ServoLead {
 public:
  explicit ServoLead(std::shared_ptr<const RobotModel> model);

  /// Takes the plan of the next cycle; forgets the earlier ones if `resting`. Does not allocate
  /// after the first call.
  void plan(const JointArray<double>& angle, const motion::Kinematics& body, const Pose& X_OT,
            std::array<bool, 2> stands, bool resting);

  /// The leg commands for the last plan but one, clamped to the command range.
  void apply(JointArray<double>& angle);

  /// Torque the plan asks of each leg joint [N m], after apply().
  const JointArray<double>& torque() const { return torque_; }

  /// Lists the plans.
  void archive(Archive& archive);

 private:
  struct Link {
    std::size_t body = 0;
    Joint joint{};
  };
  struct Wrench {
    Vec3 force = Vec3::Zero();   // [N]
    Vec3 moment = Vec3::Zero();  // [N m] about the origin of O
  };

  const PlannedPose& before() const { return plans_[(newest_ + 1) % 3]; }
  const PlannedPose& now() const { return plans_[(newest_ + 2) % 3]; }
  const PlannedPose& after() const { return plans_[newest_]; }
  Vec3 calcNeed(std::size_t body) const;
  Wrench calcGround() const;
  std::array<Wrench, 2> shareGround(const Wrench& ground) const;
  void addTorques(Wrench wrench, const std::vector<Link>& leg);

  std::shared_ptr<const RobotModel> model_;
  std::array<std::vector<Link>, 2> legs_;  // by Foot, from the sole to the hip
  double dt_;                              // [s] of a cycle
  std::array<PlannedPose, 3> plans_;
  std::size_t newest_ = 0;
  JointArray<double> half_play_;  // [rad]
  JointArray<double> torque_;     // [N m]
};

}  // namespace nao::walk
