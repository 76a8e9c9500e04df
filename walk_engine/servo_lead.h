#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "motion/kinematics.h"

namespace nao::walk {

/// What the ground does to one foot: a force at a point, both in frame O.
struct FootLoad {
  Vec3 p_O = Vec3::Zero();    // [m]
  Vec3 force = Vec3::Zero();  // [N]
};

/// The command that makes the leg servos follow a planned motion. A servo with proportional gain kp
/// and damping kd gives the torque tau only when its command is ahead of its angle:
///   command = q + (kd / kp + half a cycle) dq/dt + tau / kp.
/// tau is what holds the robot's weight: the load under each foot and the weight of the links
/// below each hinge; the links' own accelerations are left out.
class ServoLead {
 public:
  explicit ServoLead(std::shared_ptr<const RobotModel> model);

  /// Forgets the last planned angles: the next call sees no motion.
  void reset() { moving_ = false; }

  /// Turns the planned leg angles in `angle` into commands, clamped to the command range. `body`
  /// holds the planned pose, `X_OT` the torso's place.
  void apply(const motion::Kinematics& body, const Pose& X_OT, const std::array<FootLoad, 2>& loads,
             JointArray<double>& angle);

 private:
  struct Link {
    std::size_t body = 0;
    Joint joint{};
  };

  void addTorques(const motion::Kinematics& body, const Pose& X_OT, const FootLoad& load,
                  const std::vector<Link>& leg);

  std::shared_ptr<const RobotModel> model_;
  std::array<std::vector<Link>, 2> legs_;  // by Foot, from the sole to the hip
  double half_cycle_;                      // [s]
  JointArray<double> torque_;              // [N m]
  JointArray<double> last_;                // [rad] planned one cycle ago
  bool moving_ = false;
};

}  // namespace nao::walk
