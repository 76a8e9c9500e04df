#pragma once

#include "core/archive.h"
#include "core/robot_model.h"
#include "sim/body_plan.h"

namespace nao::sim {

struct DriveTerms;

/// One motor with its gear, linearly implicit in angle and rate over a step of h:
///   servo      kp (command - theta) - kd theta',  at most stiffness * efficiency * stall *
///              (1 - |theta'| / no-load speed while driving); a part `duty_root` of its duty
///              d = kp (command - theta) / (efficiency * stall) may be sign(d) sqrt|d| instead.
///              At its limit the gear holds more than it lifts: a load that turns the motor back
///              loses as large a part in it, so that it takes stiffness * stall / efficiency
///   friction   as much of its budget as stops the motion, never more: it really sticks. What
///              creeps gives way in proportion to its torque, up to its budget; beside friction
///              that sticks it sticks, too
///   gear       rigid; or with play and compliance: then the rotor's angle theta is a state of its
///              own, and T = k deadzone(theta - q) + d (theta' - q') turns the link. theta' is
///              eliminated by one scalar solve, so that the link sees one implicit torque.
/// Stiffness scales the torque limit, not the gains. Without current a motor holds still with a
/// part of its stall torque (5 % if its gear loses as much as a Nao's) and brakes like a shorted
/// one, stall / no-load speed per rad/s.
class GearedMotor {
 public:
  GearedMotor(const BodyPlan& plan, std::size_t joint);

  /// What a step starts from.
  struct Input {
    double h = 0;         // [s]
    double q = 0, u = 0;  // [rad], [rad/s] of the link
    double command = 0;   // [rad]
    double stiffness = 0;
    bool open = false;  // windings open: without current it does not brake
    double resist_forward = 0, resist_backward = 0;  // [N m] budgets of friction
    double creep_forward = 0, creep_backward = 0;    // [N m] of friction that creeps
    double creep_slope = 0;                          // [N m s/rad] of the same
    double viscous = 0;                              // [N m s/rad]
    double torque_part = 1, speed_part = 1;
    double disturbance = 0;  // [N m] on the link

    void take(const DriveTerms& terms, std::size_t joint);
  };

  /// The rotor at rest where the link is.
  void reset(double q);
  /// Takes the link's motion over, so that angle() and rate() are of now.
  void observe(double q, double u);

  void prepare(const Input& input);
  /// Torque on the link at the start of the step with rates carried on [N m], and its fall per unit
  /// of change of the link's rate [N m s/rad].
  double now() const { return now_; }
  double change() const { return change_; }
  /// The torque at this very state, after prepare() with h = 0: without friction, what the gear
  /// holds with, or play.
  double smoothTorque() const;
  /// After a solve for the link's change of rate: what is beyond its limit stays at it, friction
  /// starts or stops to slide, gears touch or let go. True if any did: solve again.
  bool revise(double du);
  /// Ends the step.
  void finish(double du);

  bool soft() const { return soft_; }
  double angle() const { return angle_ - zero_; }  // [rad] as the encoder on the motor's side
  double rate() const { return rate_; }            // [rad/s]
  double torque() const { return torque_; }        // [N m] of the motor over the last step
  bool saturated() const { return saturated_; }    // its servo was at its limit in the last step
  double load() const { return load_; }            // [N m] through the gear to the link

  void archive(Archive& archive);

 private:
  GearedMotor(const Actuator& actuator, const Transmission& gear);
  enum class Grip : std::uint64_t { None, Stuck, Sliding };  // of friction; no padding
  void prepareServo(const Input& input);
  double easedError(double error, double& slope) const;
  void bendServo(double error, double& torque, double& slope) const;
  void prepareFriction(const Input& input);
  void prepareGear(const Input& input);
  bool slidesAt(double rate) const;
  void slide(double direction);
  void engage(int side);
  void combine();
  bool reviseServo(double dw);
  bool reviseFriction(double dw);
  bool reviseGear(double dw, double du);
  double rotorChange(double du) const { return soft_ ? from_rotor_ + from_link_ * du : du; }
  double frictionNow() const;
  double frictionChange() const;

  double kp_, kd_, stall_, efficiency_, no_load_, rotor_, hold_;
  double deadband_ = 0, deadband_ease_ = 0, duty_root_ = 0, torque_part_ = 1, zero_ = 0;
  bool soft_;
  double half_play_, stiffness_, damping_;

  // State.
  double angle_ = 0, rate_ = 0;  // of the rotor
  Grip grip_ = Grip::Stuck;
  double torque_ = 0, load_ = 0;

  // Of this step.
  double h_ = 0;
  double servo_ = 0, servo_change_ = 0, limit_up_ = 0, limit_down_ = 0;
  bool saturated_ = false;
  double resist_forward_ = 0, resist_backward_ = 0, rest_ = 0, viscous_ = 0, slide_ = 0;
  double gap_ = 0, closing_ = 0;  // rotor before link, at the end of the step as rates are now
  int side_ = 0;                  // which end of the play pushes; 0: neither
  double gear_ = 0, gear_change_ = 0;
  double from_rotor_ = 0, from_link_ = 0;  // change of the rotor's rate = the one + the other * du
  double disturbance_ = 0;
  double now_ = 0, change_ = 0;
  int grip_changes_ = 0, side_changes_ = 0;
};

}  // namespace nao::sim
