#include "sim/multibody.h"

#include "sim/simbody_tree.h"

namespace nao::sim {

class Multibody::Impl {
 public:
  Impl(const RobotModel& model, double gravity)
      : model_(model), gravity_(gravity), tree_(model), state_(tree_.finish()) {}

  void set(const TreeState& state) {
    SimTK::Vector& q = state_.updQ();  // once: each upd...() invalidates what was computed
    for (int i = 0; i < q.size(); ++i) q[i] = state.q[i];
    SimTK::Vector& u = state_.updU();
    for (int i = 0; i < u.size(); ++i) u[i] = state.u[i];
    tree_.system().realize(state_, SimTK::Stage::Velocity);
  }

  // By articulated bodies: none of our own steps.
  Eigen::VectorXd calcAcceleration(const Eigen::VectorXd& f) {
    const Eigen::VectorXd all = f + tree_.calcGeneralized(state_, weights(), {});
    SimTK::Vector forces(static_cast<int>(all.size()));
    for (int i = 0; i < forces.size(); ++i) forces[i] = all[i];
    const SimTK::Vector_<SimTK::SpatialVec> none(tree_.matter().getNumBodies(),
                                                 SimTK::SpatialVec(SimTK::Vec3(0)));
    SimTK::Vector acceleration;
    SimTK::Vector_<SimTK::SpatialVec> of_bodies;
    tree_.system().realize(state_, SimTK::Stage::Dynamics);
    tree_.matter().calcAccelerationIgnoringConstraints(state_, forces, none, acceleration,
                                                       of_bodies);
    return Eigen::Map<const Eigen::VectorXd>(&acceleration[0], acceleration.size());
  }

  std::vector<ExternalForce> weights() const {
    std::vector<BodyMotion> motion;
    tree_.calcMotion(state_, motion);
    std::vector<ExternalForce> out;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const Body& body = model_.bodies[i];
      out.push_back({static_cast<int>(i), motion[i].p_WB + motion[i].R_WB * body.p_BoBcm,
                     Vec3(0, 0, -body.mass * gravity_)});
    }
    return out;
  }

  const RobotModel& model_;
  double gravity_;
  SimbodyTree tree_;
  SimTK::State state_;
};

Multibody::Multibody(const RobotModel& model, double gravity)
    : impl_(std::make_unique<Impl>(model, gravity)) {}
Multibody::~Multibody() = default;

int Multibody::speedCount() const { return impl_->state_.getNU(); }
int Multibody::rootSpeedCount() const { return impl_->tree_.fixedBase() ? 0 : 6; }
int Multibody::rootPositionCount() const { return impl_->tree_.fixedBase() ? 0 : 7; }

TreeState Multibody::zeroState() const {
  TreeState state{Eigen::VectorXd::Zero(impl_->state_.getNQ()),
                  Eigen::VectorXd::Zero(impl_->state_.getNU())};
  if (!impl_->tree_.fixedBase()) state.q[0] = 1;
  return state;
}

void Multibody::setState(const TreeState& state) { impl_->set(state); }
void Multibody::calcMotion(std::vector<BodyMotion>& motion) const {
  impl_->tree_.calcMotion(impl_->state_, motion);
}
void Multibody::calcVelocityBias(Eigen::VectorXd& bias) const {
  bias = impl_->tree_.calcVelocityBias(impl_->state_);
}
Eigen::VectorXd Multibody::calcAcceleration(const Eigen::VectorXd& f) const {
  return impl_->calcAcceleration(f);
}
Eigen::MatrixXd Multibody::calcMassMatrix() const {
  return impl_->tree_.calcMassMatrix(impl_->state_);
}

}  // namespace nao::sim
