#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/joint.h"
#include "core/random.h"
#include "core/robot_io.h"
#include "core/sim_time.h"
#include "sim/body_plan.h"

namespace nao::sim {

/// A number an effect depends on, with all that is needed to show it, set it and identify it.
struct Parameter {
  std::string name;
  std::string unit;
  double nominal = 0;  // as a catalogue entry that is switched on without a number
  double neutral = 0;  // at which the effect does nothing
  double min = 0;
  double max = 0;
  double smallest = 0;  // size of interest: a smaller deviation from neutral matters to nobody
};
using ParameterValues = std::map<std::string, double>;

/// What the drives go through at the start of a step; arrays are indexed by Joint.
struct DriveMoment {
  SimTime time{};
  double h = 0;                            // [s] length of the step
  const JointArray<double>& angle;         // [rad] on the motor's side of the gear
  const JointArray<double>& rate;          // [rad/s]
  const JointArray<double>& command;       // [rad] that the servo follows
  const JointArray<double>& stiffness;     // of the command
  const JointArray<double>& motor_torque;  // [N m] of the step before, before friction
  const JointArray<double>& load_torque;   // [N m] of the step before, through the gear to the link
};

/// What effects add to the ideal drives for one step; arrays are indexed by Joint. Friction is a
/// budget, the most that a joint can resist: the step's solve takes as much of it as stops the
/// motion, never more, so that a joint really sticks. Budgets of several effects add up. Friction
/// that creeps resists by as much at most, and in proportion to a slow joint's rate: `creep_slope`.
struct DriveTerms {
  /// Those of ideal drives.
  void reset(std::size_t joints);

  JointArray<double> resist_forward;   // [N m] dry friction against motion towards larger angles
  JointArray<double> resist_backward;  // [N m] against motion towards smaller angles
  JointArray<double> creep_forward;    // [N m] the same of friction that creeps
  JointArray<double> creep_backward;   // [N m]
  JointArray<double> creep_slope;      // [N m s/rad]
  JointArray<double> viscous;          // [N m s/rad]
  JointArray<double> torque_part;      // of the torque limit that is left, 1: all
  JointArray<double> speed_part;       // of the no-load speed that is left, 1: all
  JointArray<double> disturbance;      // [N m] on the link
};

/// Which of the calls an effect overrides every step or cycle: the others cost nothing.
enum class Acts : unsigned { Once = 0, OnCommand = 1, OnDrive = 2, OnSensors = 4, OnImu = 8 };
constexpr Acts operator|(Acts a, Acts b) {
  return static_cast<Acts>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool includes(Acts all, Acts one) {
  return (static_cast<unsigned>(all) & static_cast<unsigned>(one)) != 0;
}

/// One imperfection of the real robot, acting on some of its joints or on all. An effect overrides
/// the few places where it acts; each call handles all joints. Parameters and joints are fixed at
/// construction; what changes with time is listed in archive(). One simulation thread.
class Effect {
 public:
  virtual ~Effect() = default;

  /// Once, while the robot is built: what is constant costs nothing later.
  virtual void alterPlan(BodyPlan&) {}
  /// Once per reset: where the robot starts.
  virtual void alterStart(Pose2&) {}
  /// Every step of `h` [s], before the servos: latency, rate limits, quantisation. `command` holds
  /// what was sent last, or what the effect before this one made of it.
  virtual void alterCommand(JointCommand& /*command*/, SimTime /*now*/, double /*h*/) {}
  /// Every step: friction, limits and disturbances of the drives.
  virtual void alterDrive(const DriveMoment&, DriveTerms&) {}
  /// Every `cycle` of the robot: what accelerometer and gyroscope measured, before the board fuses
  /// them to angles. The rest of `frame` is not yet there.
  virtual void alterImu(SensorFrame& /*frame*/, Duration /*cycle*/) {}
  /// Every `cycle` of the robot, after all sensors: noise, bias, delay.
  virtual void alterSensors(SensorFrame& /*frame*/, Duration /*cycle*/) {}

  /// Which of the calls that its type lists this one needs: the others cost nothing.
  virtual Acts needed(Acts listed) const { return listed; }
  /// What changes with time: saved, restored and hashed.
  virtual void archive(Archive&) {}
  /// The random numbers that this run's effect has drawn for good, by name.
  virtual void listDraw(std::map<std::string, double>& /*draw*/) const {}
};

/// What an effect is made from.
struct EffectSetup {
  const ParameterValues& values;   // complete
  const JointArray<bool>& joints;  // it acts on
  const RobotModel& model;         // nominal
  Duration step;                   // of the world
  Random random;                   // this effect's own stream
  bool named = false;              // the file names the joints: else they are all

  double value(const char* name) const { return values.at(name); }
  std::vector<std::size_t> acting() const;  // the joints it acts on
  /// Those of them that have a hinge; hands have none.
  std::vector<std::size_t> hinged() const;
  /// The bodies that hang directly on these joints.
  std::vector<std::size_t> bodies() const;
};

/// An effect as listed in the catalogue: name, explanation, parameters and how to make one.
struct EffectType {
  std::string name;
  std::string summary;  // one sentence
  std::vector<Parameter> parameters;
  Acts acts = Acts::Once;
  std::function<std::unique_ptr<Effect>(const EffectSetup&)> make;
};

template <class T>
std::unique_ptr<Effect> makeEffect(const EffectSetup& setup) {
  return std::make_unique<T>(setup);
}

/// An effect that is a change of the plan and nothing else.
std::unique_ptr<Effect> changePlan(std::function<void(BodyPlan&)> change);

}  // namespace nao::sim
