#include "sim/multibody.h"

#include <Simbody.h>

namespace nao::sim {
namespace {

SimTK::Vec3 toSimTK(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

SimTK::Rotation toSimTK(const Mat3& R) {
  return SimTK::Rotation(SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0),
                                      R(2, 1), R(2, 2)));
}

Vec3 toEigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

Mat3 toEigen(const SimTK::Rotation& R) {
  Mat3 out;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out(row, column) = R[row][column];
  }
  return out;
}

SimTK::MassProperties massProperties(const Body& body) {
  const Mat3& I = body.I_Bcm;
  const SimTK::Inertia central(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
  const SimTK::Vec3 com = toSimTK(body.p_BoBcm);
  return {body.mass, com, central.shiftFromMassCenter(com, body.mass)};
}

// Simbody's pins turn about z: this frame has its z along `axis`.
SimTK::Rotation hingeFrame(const Vec3& axis) {
  return SimTK::Rotation(SimTK::UnitVec3(toSimTK(axis)), SimTK::ZAxis);
}

}  // namespace

class Multibody::Impl {
 public:
  Impl(const RobotModel& model, double gravity)
      : model_(model),
        fixed_base_(model.fixed_base),
        weights_(static_cast<int>(model.bodies.size()) + 1) {
    for (const Body& body : model.bodies) {
      add(body);
      coms_.push_back(toSimTK(body.p_BoBcm));
      weights_[static_cast<int>(coms_.size())] = body.mass * gravity;
    }
    state_ = system_.realizeTopology();
    system_.realizeModel(state_);
    gravity_forces_.resize(matter_.getNumBodies());
    no_forces_.resize(matter_.getNumBodies());
    no_forces_ = SimTK::SpatialVec(SimTK::Vec3(0));
    zero_mobility_.resize(matter_.getNumMobilities());
    zero_mobility_ = 0;
    zero_acceleration_ = zero_mobility_;
  }

  void set(const TreeState& state) {
    SimTK::Vector& q = state_.updQ();  // once: each upd...() invalidates what was computed
    for (int i = 0; i < q.size(); ++i) q[i] = state.q[i];
    SimTK::Vector& u = state_.updU();
    for (int i = 0; i < u.size(); ++i) u[i] = state.u[i];
    system_.realize(state_, SimTK::Stage::Velocity);
  }

  // Poses are Simbody's. Velocities follow from them and u: asking for each costs a look-up.
  void calcMotion(std::vector<BodyMotion>& motion) const {
    motion.resize(bodies_.size());
    const SimTK::Vector& u = state_.getU();
    const int root_speeds = fixed_base_ ? 0 : 6;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const SimTK::Transform& X_GB = bodies_[i].getBodyTransform(state_);
      BodyMotion& body = motion[i];
      body.R_WB = toEigen(X_GB.R());
      body.p_WB = toEigen(X_GB.p());
      if (i == 0) {
        if (fixed_base_) continue;
        body.w_WB = Vec3(u[0], u[1], u[2]);
        body.v_WB = Vec3(u[3], u[4], u[5]);
        continue;
      }
      const BodyMotion& parent = motion[static_cast<std::size_t>(model_.bodies[i].parent)];
      const double rate = u[root_speeds + static_cast<int>(i) - 1];
      body.w_WB = parent.w_WB + rate * (body.R_WB * model_.bodies[i].axis);
      body.v_WB = parent.v_WB + parent.w_WB.cross(body.p_WB - parent.p_WB);
    }
  }

  void calcVelocityBias(Eigen::VectorXd& bias) {
    matter_.calcResidualForceIgnoringConstraints(state_, zero_mobility_, no_forces_,
                                                 zero_acceleration_, residual_);
    bias.resize(residual_.size());
    for (int i = 0; i < residual_.size(); ++i) bias[i] = residual_[i];
  }

  Eigen::VectorXd calcAcceleration(const Eigen::VectorXd& f) {
    calcGravity();
    SimTK::Vector forces(static_cast<int>(f.size()));
    for (int i = 0; i < forces.size(); ++i) forces[i] = f[i];
    SimTK::Vector acceleration;
    SimTK::Vector_<SimTK::SpatialVec> body_acceleration;
    system_.realize(state_, SimTK::Stage::Dynamics);
    matter_.calcAccelerationIgnoringConstraints(state_, forces, gravity_forces_, acceleration,
                                                body_acceleration);
    return Eigen::Map<const Eigen::VectorXd>(&acceleration[0], acceleration.size());
  }

  Eigen::MatrixXd calcMassMatrix() const {
    SimTK::Matrix M;
    matter_.calcM(state_, M);
    Eigen::MatrixXd out(M.nrow(), M.ncol());
    for (int r = 0; r < M.nrow(); ++r) {
      for (int c = 0; c < M.ncol(); ++c) out(r, c) = M(r, c);
    }
    return out;
  }

  int speedCount() const { return state_.getNU(); }
  int positionCount() const { return state_.getNQ(); }
  bool fixedBase() const { return fixed_base_; }

 private:
  void add(const Body& body) {
    const SimTK::Body::Rigid rigid(massProperties(body));
    const SimTK::Transform X_PB(toSimTK(Mat3(body.X_PB.linear())),
                                toSimTK(Vec3(body.X_PB.translation())));
    if (body.parent >= 0) {
      const SimTK::Transform hinge(hingeFrame(body.axis));
      bodies_.push_back(SimTK::MobilizedBody::Pin(bodies_[static_cast<std::size_t>(body.parent)],
                                                  X_PB * hinge, rigid, hinge));
    } else if (fixed_base_) {
      bodies_.push_back(SimTK::MobilizedBody::Weld(matter_.Ground(), X_PB, rigid, {}));
    } else {
      bodies_.push_back(SimTK::MobilizedBody::Free(matter_.Ground(), {}, rigid, {}));
    }
  }

  void calcGravity() {
    gravity_forces_[0] = SimTK::SpatialVec(SimTK::Vec3(0));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto slot = static_cast<int>(i) + 1;
      const SimTK::Vec3 weight(0, 0, -weights_[slot]);
      const SimTK::Vec3 arm = bodies_[i].getBodyRotation(state_) * coms_[i];
      gravity_forces_[slot] = SimTK::SpatialVec(arm % weight, weight);
    }
  }

  const RobotModel& model_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_{system_};
  std::vector<SimTK::MobilizedBody> bodies_;  // by body of the model
  bool fixed_base_;
  SimTK::State state_;
  std::vector<SimTK::Vec3> coms_;
  SimTK::Vector weights_;  // [N] by mobilized body
  SimTK::Vector_<SimTK::SpatialVec> gravity_forces_, no_forces_;
  SimTK::Vector zero_mobility_, zero_acceleration_, residual_;
};

Multibody::Multibody(const RobotModel& model, double gravity)
    : impl_(std::make_unique<Impl>(model, gravity)) {}
Multibody::~Multibody() = default;

int Multibody::speedCount() const { return impl_->speedCount(); }
int Multibody::rootSpeedCount() const { return impl_->fixedBase() ? 0 : 6; }
int Multibody::rootPositionCount() const { return impl_->fixedBase() ? 0 : 7; }

TreeState Multibody::zeroState() const {
  TreeState state{Eigen::VectorXd::Zero(impl_->positionCount()),
                  Eigen::VectorXd::Zero(impl_->speedCount())};
  if (!impl_->fixedBase()) state.q[0] = 1;
  return state;
}

void Multibody::setState(const TreeState& state) { impl_->set(state); }
void Multibody::calcMotion(std::vector<BodyMotion>& motion) const { impl_->calcMotion(motion); }
void Multibody::calcVelocityBias(Eigen::VectorXd& bias) const { impl_->calcVelocityBias(bias); }
Eigen::VectorXd Multibody::calcAcceleration(const Eigen::VectorXd& f) const {
  return impl_->calcAcceleration(f);
}
Eigen::MatrixXd Multibody::calcMassMatrix() const { return impl_->calcMassMatrix(); }

}  // namespace nao::sim
