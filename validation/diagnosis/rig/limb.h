#pragma once

#include <map>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/rig/joint_load.h"

namespace nao::validation {

class RigSet;

/// The limb of one joint of a set, alone: nothing passes from limb to limb of a robot whose base is
/// held. Limbs that share a motor with it come along, unless nobody measured that motor: then it
/// only holds. Joints below are the limb's own. Any thread.
class Limb {
 public:
  /// `set` must outlive it.
  Limb(const RigSet& set, Joint joint_of_robot);

  const RigSet& set() const { return set_; }
  const RobotModel& model() const { return model_; }
  Joint joint() const { return joint_; }
  /// Joints of the robot that hang on the joint, nearest first.
  std::vector<Joint> carried() const;
  /// What the joint's link and those that hang on it have of inertia about their centres of mass,
  /// along its axis with all joints at 0, as a part of its rotor's: the root of the sum of squares.
  double linkInertia() const;
  /// With the gains of a motion.
  RobotModel modelIn(std::size_t motion) const;
  /// What the joints were told, a row per cycle; those that were not hold what they had.
  std::vector<JointCommand> orders(std::size_t motion) const;
  /// What they did.
  MeasuredMotion measured(std::size_t motion) const;
  /// Random torques on the joints that `noise` of this joint leads one to expect: on its neighbours
  /// as much more or less than nominal as on itself, up to four times.
  std::vector<EffectSetting> disturbances(const JointNoise& noise) const;
  /// Effects on the robot, as far as they act here.
  std::vector<EffectSetting> effects(const std::vector<EffectSetting>& on_robot) const;

 private:
  const RigSet& set_;
  RobotModel model_;
  std::vector<Joint> whole_;        // of the limb's joints, what the whole robot calls them
  std::map<Joint, Joint> in_limb_;  // the other way
  Joint joint_;
};

/// How many steps of a limb go by one inertia (sim::InertiaCourse): 1 ms, by which a leg's angles
/// are off by less than a hundredth of an encoder's count. Two of steps that are that long: these
/// tell no more than what a cause changes.
int inertiaEvery(Duration step);

/// A name that two lists of effects share only if they act alike; of them in one motion.
std::string keyOf(const std::vector<EffectSetting>& effects);
std::string keyOf(std::size_t motion, const std::vector<EffectSetting>& effects);

}  // namespace nao::validation
