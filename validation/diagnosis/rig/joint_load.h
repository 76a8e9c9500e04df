#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "sim/joint_rig.h"

namespace nao::validation {

/// The bandwidth [Hz] of what is taken over from the measurement. A joint's angle with its count of
/// 1.5 mrad, six repeats and 10 Hz gives accelerations known to 1 rad/s^2; motions of the standard
/// set have little beyond 5 Hz. Free choice between the two.
inline constexpr double kLoadBandwidth = 10;

/// What the joints of a robot with a fixed base reported over one run: a row per time, a column per
/// Joint [rad]; a joint that was not measured has the angle that it held.
struct MeasuredMotion {
  double dt = 0;  // [s]
  Eigen::MatrixXd angle;
  std::vector<bool> assumed{};  // joints that were not measured, said to rest; empty: none
};

/// How a robot is run for a joint's load.
struct LoadOptions {
  double settle = 0.5;  // [s]
  Duration step = std::chrono::microseconds(250);
  int per_row = 10;  // 1 ms for a Nao's cycle: orders come in stairs, which shake the neighbours
  double bandwidth = kLoadBandwidth;
  std::uint64_t seed = 1;       // of random effects
  std::vector<Joint> others{};  // whose angles go along, as they limit this joint
  int inertia_every = 1;        // steps, as in sim::HingeRun
};

/// `values`, one per row, on `per_row` values per row, linear between.
Eigen::VectorXd spreadOut(const std::vector<double>& rows, int per_row);

/// How all links of a limb moved: a row per value, a column per coordinate.
struct LimbMotion {
  double dt = 0;  // [s]
  Eigen::MatrixXd q, u, acceleration;
};

/// The model with these effects (its own too only if they are listed) plays `orders` (one per row,
/// a row is a cycle of the robot). What the joints were measured to do otherwise, smoothed to the
/// bandwidth, is added.
LimbMotion calcLimbMotion(const RobotModel& model, const std::vector<EffectSetting>& effects,
                          const std::vector<JointCommand>& orders, const MeasuredMotion& measured,
                          const LoadOptions& options,
                          const sim::EffectCatalogue& catalogue = sim::standardEffects());

/// What `joint` carries along that motion if links weigh what the model with these effects has:
/// inverse dynamics.
sim::JointLoad loadAlong(const LimbMotion& motion, const RobotModel& model,
                         const std::vector<EffectSetting>& effects, Joint joint,
                         const LoadOptions& options,
                         const sim::EffectCatalogue& catalogue = sim::standardEffects());

/// The load of `joint` along its motion with the same effects. Whatever moves the joint otherwise
/// shakes its neighbours otherwise, so that every list of effects has a load of its own.
/// @throws InputError for a robot whose base is free.
sim::JointLoad calcJointLoad(const RobotModel& model, const std::vector<EffectSetting>& effects,
                             const std::vector<JointCommand>& orders,
                             const MeasuredMotion& measured, Joint joint,
                             const LoadOptions& options,
                             const sim::EffectCatalogue& catalogue = sim::standardEffects());

}  // namespace nao::validation
