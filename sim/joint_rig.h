#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"

namespace nao::sim {

/// What an effect is to one joint that is looked at alone.
enum class JointReach {
  Rig,   // it acts on the joint's motor, gear, command or sensors
  Load,  // it changes bodies, gravity or damping, hence the load: calculate that anew
  None,  // it acts elsewhere: ground, inertial unit, force sensors
};
JointReach reachOf(const EffectType& type);
/// True if a rig can tell what the effect does to one joint, its load calculated anew or not.
bool actsOnJoint(const EffectType& type);

/// The rest of the body as one joint feels it while everything moves as given; `per_row` values per
/// row of orders, linear between values, the last at the last row. At angle q of the link the body
/// asks for
///   inertia q'' + torque + slope (q - reference)
/// from the motor, whose own rotor is not part of it.
struct JointLoad {
  int per_row = 1;
  std::vector<double> inertia;    // [kg m^2]
  std::vector<double> torque;     // [N m] at `reference`
  std::vector<double> reference;  // [rad] of the link
  std::vector<double> slope;      // [N m/rad]
  /// [rad] Angles of the joints that limit this one's range, by name.
  std::map<std::string, std::vector<double>> others;
};

/// What is sent to the joint from each row of time on.
struct JointOrders {
  std::vector<double> angle;      // [rad]
  std::vector<double> stiffness;  // empty: 1
};

/// What differs between two runs of the same orders.
struct RigChance {
  std::uint64_t stream = 0;  // of all random numbers; they do not depend on the effects
  Random::Pair pair = Random::Pair::First;
  double torque_sd = 0;       // [N m] of an Ornstein-Uhlenbeck torque on the link
  double torque_time = 0.05;  // [s] its correlation time
  double start = 0;           // [s] by which the run comes late: the orders, and with them the load
  double lead = 0;            // [s] by which the orders come before the load
};

/// What the joint reports at each row, before the orders of that row act.
struct JointSignals {
  std::vector<double> angle;    // [rad] of its encoder
  std::vector<double> current;  // [A]
};

/// One joint of a robot alone: motor, gear, stops, effects and sensors as in a World, the rest of
/// the body a JointLoad. Costs a hundredth of the World. Hinges that share a motor are one. Rows
/// are a cycle of the robot apart. A run begins at rest with the first orders given `settle` ago.
/// Constant; any thread may ask.
class JointRig {
 public:
  /// `step` divides the rows' distance `row`. `others` are the joints that may limit this one.
  /// @throws InputError if the joint has no hinge or the step does not divide a row.
  JointRig(const RobotModel& model, Joint joint, Duration row, Duration step,
           const std::vector<std::string>& others = {});

  /// `effects` act, those of the model too only if they are listed; an effect that cannot act on
  /// this joint does nothing. @throws InputError as EffectChain does.
  JointSignals run(const std::vector<EffectSetting>& effects, const JointOrders& orders,
                   const JointLoad& load, const RigChance& chance, Duration settle,
                   const EffectCatalogue& catalogue = standardEffects()) const;

  /// The robot that has this joint alone, and behind it those that limit it.
  const RobotModel& model() const { return cut_; }
  Duration row() const { return cut_.cycle; }
  Duration step() const { return step_; }

 private:
  void keepCoupling(const RobotModel& model, Joint joint);
  std::vector<EffectSetting> cut(const std::vector<EffectSetting>& settings,
                                 const EffectCatalogue& catalogue) const;

  Duration step_;
  RobotModel cut_;
  std::map<Joint, Joint> kept_;  // of the whole robot -> of the cut one
};

}  // namespace nao::sim
