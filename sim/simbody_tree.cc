#include "sim/simbody_tree.h"

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

Eigen::VectorXd toEigen(const SimTK::Vector& v) {
  Eigen::VectorXd out(v.size());
  for (int i = 0; i < v.size(); ++i) out[i] = v[i];
  return out;
}

}  // namespace

SimbodyTree::SimbodyTree(const RobotModel& model) : model_(model) {
  for (const Body& body : model.bodies) add(body);
}

void SimbodyTree::add(const Body& body) {
  const SimTK::Body::Rigid rigid(massProperties(body));
  const SimTK::Transform X_PB(toSimTK(Mat3(body.X_PB.linear())),
                              toSimTK(Vec3(body.X_PB.translation())));
  if (body.parent >= 0) {
    const SimTK::Transform hinge(hingeFrame(body.axis));
    bodies_.push_back(SimTK::MobilizedBody::Pin(bodies_[static_cast<std::size_t>(body.parent)],
                                                X_PB * hinge, rigid, hinge));
  } else if (model_.fixed_base) {
    bodies_.push_back(SimTK::MobilizedBody::Weld(matter_.Ground(), X_PB, rigid, {}));
  } else {
    bodies_.push_back(SimTK::MobilizedBody::Free(matter_.Ground(), {}, rigid, {}));
  }
}

SimTK::State SimbodyTree::finish() {
  SimTK::State state = system_.realizeTopology();
  system_.realizeModel(state);
  return state;
}

void SimbodyTree::calcMotion(const SimTK::State& state, std::vector<BodyMotion>& motion) const {
  motion.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const SimTK::Transform& X_GB = bodies_[i].getBodyTransform(state);
    const SimTK::SpatialVec& V_GB = bodies_[i].getBodyVelocity(state);
    motion[i] = {toEigen(X_GB.R()), toEigen(X_GB.p()), toEigen(V_GB[0]), toEigen(V_GB[1])};
  }
}

Eigen::VectorXd SimbodyTree::calcVelocityBias(const SimTK::State& state) const {
  const SimTK::Vector still(matter_.getNumMobilities(), 0.0);
  const SimTK::Vector_<SimTK::SpatialVec> none(matter_.getNumBodies(),
                                               SimTK::SpatialVec(SimTK::Vec3(0)));
  SimTK::Vector residual;
  matter_.calcResidualForceIgnoringConstraints(state, still, none, still, residual);
  return toEigen(residual);
}

Eigen::MatrixXd SimbodyTree::calcMassMatrix(const SimTK::State& state) const {
  SimTK::Matrix M;
  matter_.calcM(state, M);
  Eigen::MatrixXd out(M.nrow(), M.ncol());
  for (int r = 0; r < M.nrow(); ++r) {
    for (int c = 0; c < M.ncol(); ++c) out(r, c) = M(r, c);
  }
  return out;
}

Eigen::VectorXd SimbodyTree::calcGeneralized(const SimTK::State& state,
                                             const std::vector<ExternalForce>& forces,
                                             const std::vector<Vec3>& moments) const {
  SimTK::Vector_<SimTK::SpatialVec> on_bodies(matter_.getNumBodies(),
                                              SimTK::SpatialVec(SimTK::Vec3(0)));
  for (std::size_t i = 0; i < moments.size(); ++i) {
    on_bodies[static_cast<int>(i) + 1][0] += toSimTK(moments[i]);
  }
  for (const ExternalForce& force : forces) {
    const auto& body = bodies_[static_cast<std::size_t>(force.body)];
    const SimTK::Vec3 f = toSimTK(force.f_W);
    const SimTK::Vec3 arm = toSimTK(force.p_W) - body.getBodyOriginLocation(state);
    on_bodies[force.body + 1] += SimTK::SpatialVec(arm % f, f);
  }
  SimTK::Vector generalized;
  matter_.multiplyBySystemJacobianTranspose(state, on_bodies, generalized);
  return toEigen(generalized);
}

}  // namespace nao::sim
