#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::hidden {

/// One motor as the second reality knows it: numbers of the nominal model, by laws of its own
/// (mujoco/mjcf.cc for what MuJoCo does, mujoco/motor.h for the rest).
struct MujocoJoint {
  std::vector<int> coordinates;  // hinges it turns; none: no motor
  double kp = 0, kd = 0;         // [N m/rad], [N m s/rad]
  double strength = 0;           // [N m] at standstill
  double top_speed = 0;          // [rad/s] without load
  double armature = 0;           // [kg m^2] of the rotor, at the joint
  double friction_loss = 0;      // [N m]
  double damping = 0;            // [N m s/rad]
  double spring = 0;             // [N m/rad] towards 0
  double bias = 0;               // [N m]
  double play = 0;               // [rad] between rotor and link, from end to end
  double turned = 0;             // [rad] by which the encoder reads too much
  double quantum = 0;            // [rad] of the encoder
  double order_delay = 0;        // [s] until an order is followed
  double report_delay = 0;       // [s] until an angle is reported
  double order_filter = 0;       // [s] time constant between order and servo
  double noise_sd = 0;           // [N m] of the random torque on the link
  double noise_time = 0;         // [s]
};

/// A robot with a fixed base, ready to be written as MJCF.
struct MujocoRobot {
  RobotModel model;  // bodies, hinges and stops, changed where effects change them
  std::vector<MujocoJoint> joints;
  double gravity = 9.80665;  // [m/s^2]
};

/// `model` with its own effects and `extra`, those of mujocoHideouts() among them.
/// @throws InputError for an effect that the second reality does not know.
MujocoRobot makeMujocoRobot(const RobotModel& model, const std::vector<EffectSetting>& extra);

}  // namespace nao::hidden
