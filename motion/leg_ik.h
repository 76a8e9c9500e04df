#pragma once

#include <array>
#include <memory>

#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::motion {

/// What LegIk found for both legs.
struct LegSolution {
  std::array<std::array<double, 6>, 2> angle{};  // [rad] by Foot: hip yaw-pitch (the same twice),
                                                 // hip roll, hip pitch, knee, ankle pitch, roll
  std::array<double, 2> yaw_demand{};  // [rad] hip yaw-pitch each leg alone would have asked for
  std::array<bool, 2> reachable{};     // position and slope of the sole met, inside the limits
  bool withinReach() const { return reachable[0] && reachable[1]; }
};

/// Inverse kinematics of a Nao's legs: hips whose three axes meet (yaw-pitch, roll, pitch), a knee,
/// an ankle whose two axes meet (pitch, roll); lengths and axes come from the model. Immutable;
/// solve() may be called from any thread and does not allocate.
///
/// Twelve demands meet eleven motors, because one motor turns both yaw-pitch hinges. Each leg's own
/// yaw-pitch angle follows from its sole's pose; the common one is
///   q = s q_left + (1 - s) q_right,   s = `left_share`.
/// With q given, each leg still meets the position and the slope (roll and pitch) of its sole
/// exactly; only the heading of a foot gives way, by about 0.7 |q - q_foot|. So s = 1 keeps a left
/// support foot exact and lets the swinging right one turn, s = 1/2 spreads the error. Whoever is
/// free to turn the torso about the vertical makes both demands equal and loses nothing:
/// calcEqualYaw().
class LegIk {
 public:
  /// Whether the model's feet hang on legs of this kind.
  static bool fits(const RobotModel& model);

  /// @throws InputError if the model does not fit().
  explicit LegIk(std::shared_ptr<const RobotModel> model);

  /// The angles that put the soles at X_TLs and X_TRs, clamped to the joints' command ranges. Out
  /// of reach, the leg is stretched towards the ankle's place. The hips are above the soles'
  /// planes.
  LegSolution solve(const Pose& X_TLs, const Pose& X_TRs, double left_share = 0.5) const;

  /// The turn of the torso about the vertical of W [rad] after which both legs ask for the same
  /// yaw-pitch angle, the torso staying where X_WT has it. Zero if none is found within 60 degrees.
  double calcEqualYaw(const Pose& X_WT, const Pose& X_WLs, const Pose& X_WRs) const;

  /// From hip to ankle, stretched [m].
  double legLength() const { return legs_[0].thigh.norm() + legs_[0].tibia.norm(); }

  /// Writes a solution into the legs' entries of a command.
  void apply(const LegSolution& solution, JointArray<double>& angle) const;

 private:
  struct Leg {
    std::array<Joint, 6> joint{};
    std::array<double, 6> lower{};  // [rad]
    std::array<double, 6> upper{};
    Vec3 p_THip = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();     // of the yaw-pitch hinge, in T
    Vec3 thigh = Vec3::Zero();     // [m] hip to knee, in the thigh; in its x-z plane
    Vec3 tibia = Vec3::Zero();     // [m] knee to ankle, in the tibia
    Pose X_SA = Pose::Identity();  // ankle in the sole
  };

  static bool findLeg(const RobotModel& model, const FootModel& foot, Leg& leg);
  static double calcYawDemand(const Leg& leg, const Pose& X_TA);
  static bool solveLeg(const Leg& leg, const Pose& X_TA, double yaw, std::array<double, 6>& q);

  std::shared_ptr<const RobotModel> model_;
  std::array<Leg, 2> legs_;
};

}  // namespace nao::motion
