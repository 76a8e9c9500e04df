#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/robot_io.h"
#include "sim/effects/catalogue.h"

namespace nao::sim {

/// What the hinges of a robot with a fixed base really did, and what its encoders said of it.
struct HingeMotion {
  double dt = 0;             // [s] between the rows of q and u
  Eigen::MatrixXd q;         // [rad] a row per time, a column per coordinate, of the links
  Eigen::MatrixXd u;         // [rad/s]
  Eigen::MatrixXd reported;  // [rad] a row per order, a column per joint
};

/// A robot with a fixed base alone in a World, its truth written down: plays `orders`, one per
/// cycle, after `settle` [s] of rest with the first of them, in steps of `step`; q and u are kept
/// `per_cycle` times a cycle. `effects` act, those of the model too only if they are listed, with
/// random numbers from `seed`.
/// @throws InputError as World does, and for a robot whose base is free.
HingeMotion runHinges(const RobotModel& model, const std::vector<EffectSetting>& effects,
                      const std::vector<JointCommand>& orders, double settle, Duration step,
                      int per_cycle, std::uint64_t seed = 1,
                      const EffectCatalogue& catalogue = standardEffects());

}  // namespace nao::sim
