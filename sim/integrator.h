#pragma once

#include <memory>

#include "sim/body_plan.h"
#include "sim/smooth_forces.h"
#include "sim/tree_dynamics.h"

namespace nao::sim {

/// Carries a tree on through SmoothForces: the modes beside the implicit one.
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Moves `tree` on by `h` [s] while what `forces` hold stays the same.
  virtual void step(SmoothForces& forces, double h, TreeState& tree) = 0;

  /// u' in `tree`, under what `forces` hold.
  virtual Eigen::VectorXd calcAcceleration(SmoothForces& forces, const TreeState& tree) = 0;
};

/// Runge and Kutta's fourth order with the dynamics of the implicit mode. `dynamics` is scratch.
std::unique_ptr<Integrator> makeRk4(const BodyPlan& plan, TreeDynamics& dynamics,
                                    const Eigen::VectorXd& rotor_inertia);

/// Simbody's Runge-Kutta-Merson with error control (1e-9), its mass matrix and forces, and a dense
/// solve: nothing of the fast path but the forces' laws.
std::unique_ptr<Integrator> makeReference(const BodyPlan& plan,
                                          const Eigen::VectorXd& rotor_inertia);

}  // namespace nao::sim
