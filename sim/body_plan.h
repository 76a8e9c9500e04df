#pragma once

#include "core/robot_model.h"
#include "core/world_model.h"

namespace nao::sim {

/// What stands between a motor and its joint when the gear is not ideal.
struct Transmission {
  double play = 0;       // [rad] total width, seen at the joint
  double stiffness = 0;  // [N m/rad] of the gear; 0: rigid
  double damping = 0;    // [N m s/rad] of a gear that is not rigid
};

/// One robot as it is built into a world: its file's model and the world's ground, changed by the
/// effects that are constant. The motion side never sees this; it knows the nominal model alone.
struct BodyPlan {
  BodyPlan(const RobotModel& nominal, const WorldModel& world)
      : model(nominal),
        gravity(world.gravity),
        ground(world.ground),
        ground_normal(world.ground_normal),
        obstacles(world.obstacles),
        transmissions(nominal.jointCount()),
        servo_deadband(nominal.jointCount()),
        servo_deadband_ease(nominal.jointCount()),
        duty_root(nominal.jointCount()),
        torque_part(nominal.jointCount(), 1.0),
        joint_zero(nominal.jointCount()) {}

  RobotModel model;
  double gravity;      // [m/s^2] along -z of W
  Material ground;     // as this robot feels it
  Vec3 ground_normal;  // of the plane through W's origin
  std::vector<Obstacle> obstacles;
  JointArray<Transmission> transmissions;
  JointArray<double> servo_deadband;       // [rad] errors up to this move nothing
  JointArray<double> servo_deadband_ease;  // part of it over which it ends; 0: at once
  JointArray<double> duty_root;            // part of the duty that follows the root of the error
  JointArray<double> torque_part;          // of the nominal one that the motor gives at most
  JointArray<double> joint_zero;           // [rad] where the joint is when its encoder says 0
  double linear_damping = 0;               // [1/s] a = -c v of every body
  double angular_damping = 0;              // [1/s]
};

}  // namespace nao::sim
