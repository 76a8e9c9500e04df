#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::motion {

/// A place F fixed on a body B.
struct Effector {
  int body = 0;
  Pose X_BF = Pose::Identity();
};

/// The place a name stands for, as ALMotion.getPosition takes it. In this order: "Torso" (the
/// root), a frame of the robot's file ("LArm" puts the end of that chain into the hand), a leg
/// chain ("LLeg", "RLeg": the sole), another chain (its last hinge), a body or a hinge.
std::optional<Effector> findEffector(const RobotModel& model, std::string_view name);

/// Forward kinematics: where every body is in the torso frame T, for given joint angles. Holds
/// the poses of the last update(); before the first one, those of all joints at 0. One per owner,
/// no locks; update() does not allocate.
class Kinematics {
 public:
  explicit Kinematics(std::shared_ptr<const RobotModel> model);

  /// `angle` [rad], one per joint; hands are ignored.
  void update(const JointArray<double>& angle);

  const Pose& getPose(int body) const { return X_TB_[static_cast<std::size_t>(body)]; }  // X_TB
  Pose calcPose(const Effector& place) const;                                            // X_TF
  Pose calcSole(Foot foot) const;                                                        // X_TS

  /// Centre of mass of the whole robot, in T [m].
  Vec3 calcCom() const;

  /// The robot frame R in T: between the soles, at the height of the lower one, axes midway between
  /// theirs (FRAME_ROBOT, as far as joint angles alone tell). Identity for a robot without feet.
  Pose calcRobotFrame() const;

  const RobotModel& model() const { return *model_; }

 private:
  std::shared_ptr<const RobotModel> model_;
  std::vector<Pose> X_TB_;
  double total_mass_ = 0;  // [kg]
};

}  // namespace nao::motion
