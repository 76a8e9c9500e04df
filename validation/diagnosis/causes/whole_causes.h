#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {

/// A cause at a place of the robot: the world it stands in, all of its joints with one number, a
/// side, a limb or a joint.
struct PlacedCause {
  Cause cause;
  std::string place;                 // "robot", "LLeg", "LHipRoll"
  std::vector<Joint> joints;         // it acts on; none: on all, or on the world
  std::vector<std::string> twins{};  // places where the same cause does nearly as much

  /// Whether it is looked for; else equal robots only differ by it.
  bool isTried() const { return !cause.free[0].starts.empty(); }
  EffectSetting setting(const std::vector<double>& x) const;
  std::string sentence(const std::string& value) const;
};

/// A cause of these joints (none: of all that `measured` has, or the world) with units and bounds,
/// as far as what the model has leaves room.
PlacedCause placedCause(const Cause& cause, const std::string& place,
                        const std::vector<Joint>& joints, const RobotModel& model,
                        const std::vector<Joint>& measured);

/// The causes of the robot level: of the ground, the body's mass, its inertial unit, every cause
/// of the joint level that acts in one way on all joints, the main ones of a leg, and of every
/// joint. What a lower level has found stands among them and competes again.
std::vector<PlacedCause> robotCauses(const RobotModel& model, const std::vector<Joint>& measured);

/// The causes of the limb level: coupled stops of two of its joints; what hangs on the chain (mass
/// and its centre, for all links of the limb at once: base parameters); the motor that two hinges
/// share; and the main causes of its joints, which compete with them. Beside them what equal robots
/// differ by in these joints, and in those of a limb that shares a motor with them.
std::vector<PlacedCause> limbCauses(const RobotModel& model, const std::string& limb,
                                    const std::vector<Joint>& measured);

/// "LArm", "LLeg" ... that have a measured joint; the group "Body" for a robot without limbs.
std::vector<std::string> limbsOf(const RobotModel& model, const std::vector<Joint>& measured);
/// The measured joints of a limb.
std::vector<Joint> jointsOf(const RobotModel& model, const std::string& limb,
                            const std::vector<Joint>& measured);

}  // namespace nao::validation
