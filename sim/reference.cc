#include "sim/hinge_ties.h"
#include "sim/integrator.h"
#include "sim/simbody_tree.h"

namespace nao::sim {
namespace {

constexpr double kAccuracy = 1e-9;  // relative local error, free choice: far below what is compared

// Hands our forces to Simbody. It has no rotor inertia, and its couplers cost more than a solve:
// u' comes from a dense solve of (M + J) u' = f - bias with tied hinges, and Simbody is given the
// forces that make its own M move so.
class Law final : public SimTK::Force::Custom::Implementation {
 public:
  Law(const BodyPlan& plan, const SimbodyTree& tree, const Eigen::VectorXd& rotor_inertia)
      : plan_(plan), tree_(tree), rotor_inertia_(rotor_inertia), torque_(rotor_inertia.size()) {}

  void setForces(SmoothForces* forces) { forces_ = forces; }

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>&,
                 SimTK::Vector_<SimTK::Vec3>&, SimTK::Vector& mobility) const override {
    if (!forces_) return;
    const Eigen::VectorXd f =
        tree_.calcMassMatrix(state) * calcAcceleration(state) + tree_.calcVelocityBias(state);
    for (int i = 0; i < mobility.size(); ++i) mobility[i] += f[i];
  }

  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

  Eigen::VectorXd calcAcceleration(const SimTK::State& state) const {
    tree_.calcMotion(state, motion_);
    const int root_u = forces_->rootSpeedCount();
    const int root_q = root_u > 0 ? 7 : 0;
    forces_->calc(&state.getQ()[0] + root_q, &state.getU()[0] + root_u, motion_, torque_,
                  on_bodies_);
    addBodies();
    const Eigen::VectorXd f = torque_ + tree_.calcGeneralized(state, on_bodies_, moments_);
    Eigen::MatrixXd A = tree_.calcMassMatrix(state);
    A.diagonal() += rotor_inertia_;
    const Eigen::LDLT<Eigen::MatrixXd> factors(A);
    Eigen::VectorXd acceleration = factors.solve(f - tree_.calcVelocityBias(state));
    HingeTies(plan_.model, root_u)
        .hold([&](Eigen::VectorXd& c) { c = factors.solve(c).eval(); },
              [](int, int) { return 0.0; }, acceleration);
    return acceleration;
  }

 private:
  // Weight and damping.
  void addBodies() const {
    moments_.assign(motion_.size(), Vec3::Zero());
    for (std::size_t i = 0; i < motion_.size(); ++i) {
      const Body& body = plan_.model.bodies[i];
      const BodyMotion& m = motion_[i];
      const Vec3 arm = m.R_WB * body.p_BoBcm;
      const Vec3 v = m.v_WB + m.w_WB.cross(arm);
      const Vec3 f_W = body.mass * (Vec3(0, 0, -plan_.gravity) - plan_.linear_damping * v);
      on_bodies_.push_back({static_cast<int>(i), m.p_WB + arm, f_W});
      moments_[i] =
          -plan_.angular_damping * (m.R_WB * (body.I_Bcm * (m.R_WB.transpose() * m.w_WB)));
    }
  }

  const BodyPlan& plan_;
  const SimbodyTree& tree_;
  const Eigen::VectorXd& rotor_inertia_;
  SmoothForces* forces_ = nullptr;
  mutable Eigen::VectorXd torque_;
  mutable std::vector<BodyMotion> motion_;
  mutable std::vector<ExternalForce> on_bodies_;
  mutable std::vector<Vec3> moments_;  // [N m] by body
};

class Reference final : public Integrator {
 public:
  Reference(const BodyPlan& plan, const Eigen::VectorXd& rotor_inertia)
      : tree_(plan.model),
        law_(new Law(plan, tree_, rotor_inertia)),
        force_(tree_.forces(), law_),
        state_(tree_.finish()),
        integrator_(tree_.system()) {
    integrator_.setAccuracy(kAccuracy);
  }

  void step(SmoothForces& forces, double h, TreeState& tree) override {
    law_->setForces(&forces);
    take(tree);
    state_.setTime(0);
    integrator_.initialize(state_);
    while (integrator_.getTime() < h) integrator_.stepTo(h);
    const SimTK::State& end = integrator_.getState();
    for (int i = 0; i < end.getNQ(); ++i) tree.q[i] = end.getQ()[i];
    for (int i = 0; i < end.getNU(); ++i) tree.u[i] = end.getU()[i];
    law_->setForces(nullptr);
  }

  Eigen::VectorXd calcAcceleration(SmoothForces& forces, const TreeState& tree) override {
    take(tree);
    tree_.system().realize(state_, SimTK::Stage::Velocity);
    law_->setForces(&forces);
    const Eigen::VectorXd acceleration = law_->calcAcceleration(state_);
    law_->setForces(nullptr);
    return acceleration;
  }

 private:
  void take(const TreeState& tree) {
    SimTK::Vector& q = state_.updQ();
    for (int i = 0; i < q.size(); ++i) q[i] = tree.q[i];
    SimTK::Vector& u = state_.updU();
    for (int i = 0; i < u.size(); ++i) u[i] = tree.u[i];
  }

  SimbodyTree tree_;
  Law* law_;  // owned by force_
  SimTK::Force::Custom force_;
  SimTK::State state_;
  SimTK::RungeKuttaMersonIntegrator integrator_;
};

}  // namespace

std::unique_ptr<Integrator> makeReference(const BodyPlan& plan,
                                          const Eigen::VectorXd& rotor_inertia) {
  return std::make_unique<Reference>(plan, rotor_inertia);
}

}  // namespace nao::sim
