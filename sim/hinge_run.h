#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/robot_io.h"
#include "sim/effects/catalogue.h"

namespace nao::sim {

/// What the hinges of a robot with a fixed base really did, and what its sensors said of it.
struct HingeMotion {
  double dt = 0;             // [s] between the rows of q and u
  Eigen::MatrixXd q;         // [rad] a row per time, a column per coordinate, of the links
  Eigen::MatrixXd u;         // [rad/s]
  Eigen::MatrixXd reported;  // [rad] a row per order, a column per joint
  Eigen::MatrixXd current;   // [A] as `reported`
};

/// How a robot is run.
struct HingeRun {
  double settle = 0;       // [s] of rest with the first order before it begins
  Duration step{};         // of physics
  int per_cycle = 1;       // how often q and u are kept
  std::uint64_t seed = 1;  // of the effects' random numbers
  double late = 0;         // [s] orders act from the step nearest to this after their row
  /// Steps from one calculation of mass matrix and bias to the next (InertiaCourse); more than one
  /// is for a robot that can touch nothing.
  int inertia_every = 1;
  /// [rad] of the links; none: as the first order says.
  std::optional<JointArray<double>> start = std::nullopt;
  Random::Pair pair = Random::Pair::First;
};

/// A robot with a fixed base alone in a World, its truth written down: plays `orders`, one per
/// cycle. `effects` act, those of the model too only if they are listed.
/// @throws InputError as World does, and for a robot whose base is free.
HingeMotion runHinges(const RobotModel& model, const std::vector<EffectSetting>& effects,
                      const std::vector<JointCommand>& orders, const HingeRun& run,
                      const EffectCatalogue& catalogue = standardEffects());

}  // namespace nao::sim
