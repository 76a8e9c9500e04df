#pragma once

#include <Simbody.h>

#include <vector>

#include "core/robot_model.h"
#include "sim/body_motion.h"
#include "sim/external_force.h"

namespace nao::sim {

/// A robot's tree built in Simbody, for the oracle and the reference mode alone. Forces are added
/// through forces() before finish(), which makes the first State.
class SimbodyTree {
 public:
  explicit SimbodyTree(const RobotModel& model);

  SimTK::GeneralForceSubsystem& forces() { return forces_; }
  SimTK::State finish();

  const SimTK::MultibodySystem& system() const { return system_; }
  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }
  bool fixedBase() const { return model_.fixed_base; }

  // All at a State realized to Velocity.

  /// Poses and velocities of all bodies.
  void calcMotion(const SimTK::State& state, std::vector<BodyMotion>& motion) const;
  /// The generalized forces [N m, N] that would keep u constant without gravity.
  Eigen::VectorXd calcVelocityBias(const SimTK::State& state) const;
  Eigen::MatrixXd calcMassMatrix(const SimTK::State& state) const;
  /// What forces at points and moments [N m] by body are as generalized forces.
  Eigen::VectorXd calcGeneralized(const SimTK::State& state,
                                  const std::vector<ExternalForce>& forces,
                                  const std::vector<Vec3>& moments) const;

 private:
  void add(const Body& body);

  const RobotModel& model_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  SimTK::GeneralForceSubsystem forces_{system_};
  std::vector<SimTK::MobilizedBody> bodies_;  // by body of the model
};

}  // namespace nao::sim
