#pragma once

#include <vector>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "sim/joint_rig.h"

namespace nao::validation {

/// The bandwidth [Hz] of the motion that load torques come from. A joint's angle with its count of
/// 1.5 mrad, six repeats and 10 Hz gives accelerations known to 1 rad/s^2; motions of the standard
/// set have little beyond 5 Hz. Free choice between the two.
inline constexpr double kLoadBandwidth = 10;

/// The loads of one joint and how well they are known.
struct LoadTorque {
  sim::JointLoad load;
  std::vector<double> sd;  // [N m] of load.torque, by what the motions' noise makes of it
};

/// What the joints of a robot with a fixed base reported over one run: a row per time, a column per
/// Joint [rad]; a joint that was not measured has the angle that it held.
struct MeasuredMotion {
  double dt = 0;  // [s]
  Eigen::MatrixXd angle;
  Eigen::VectorXd angle_sd;   // [rad] of each joint's samples, for LoadTorque::sd; empty: 0
  std::vector<bool> assumed{};  // joints that were not measured, said to rest; empty: none
};

/// The load of `joint` while all joints move as measured, by inverse dynamics of the robot with
/// these effects (those of the model too only if they are listed): changed masses, gravity and
/// tilt, zeros, and how late its sensors report. Angles are those of the motors: what gears give
/// way is left out. @throws InputError for a robot whose base is free.
LoadTorque calcLoadTorque(const RobotModel& model, const std::vector<EffectSetting>& effects,
                          const MeasuredMotion& measured, Joint joint,
                          double bandwidth = kLoadBandwidth,
                          const sim::EffectCatalogue& catalogue = sim::standardEffects());

}  // namespace nao::validation
