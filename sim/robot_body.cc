#include "sim/robot_body.h"

#include <algorithm>
#include <cmath>

namespace nao::sim {
namespace {

// The quaternion after turning with angular velocity `w_W` for `h`: exact for constant w.
Eigen::Vector4d rotated(const Eigen::Vector4d& wxyz, const Vec3& w_W, double h) {
  const double angle = w_W.norm() * h;
  const double s = angle > 1e-12 ? std::sin(angle / 2) / angle * h : h / 2;
  const Eigen::Quaterniond turn(std::cos(angle / 2), s * w_W.x(), s * w_W.y(), s * w_W.z());
  const Eigen::Quaterniond now(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
  const Eigen::Quaterniond next = (turn * now).normalized();
  return {next.w(), next.x(), next.y(), next.z()};
}

}  // namespace

RobotBody::RobotBody(BodyPlan plan, Mode mode)
    : plan_(std::make_unique<const BodyPlan>(std::move(plan))),
      dynamics_(plan_->model),
      drive_(*plan_, dynamics_.rootSpeedCount()),
      stops_(plan_->model, dynamics_.rootSpeedCount()),
      contact_(*plan_),
      ties_(plan_->model, dynamics_.rootSpeedCount()),
      smooth_(dynamics_.rootSpeedCount(), drive_, stops_, contact_),
      tree_(dynamics_.zeroState()),
      hands_(plan_->model.jointCount()),
      inertia_(dynamics_.parents()),
      system_(dynamics_.parents()),
      mobility_(dynamics_.parents()),
      course_(inertia_),
      external_(Eigen::VectorXd::Zero(dynamics_.speedCount())) {
  dynamics_.setDamping(plan_->linear_damping, plan_->angular_damping);
  if (mode == Mode::Rk4) integrator_ = makeRk4(*plan_, dynamics_, drive_.rotorInertia());
  if (mode == Mode::Reference) integrator_ = makeReference(*plan_, drive_.rotorInertia());
  place({}, JointArray<double>(model().jointCount()));
}

void RobotBody::setTree(TreeState tree) {
  tree_ = std::move(tree);
  contact_.reset();
  drive_.reset(coordinates());
  course_.reset();
  moved();
}

void RobotBody::setInertiaEvery(int steps) {
  NAO_CHECK(dynamics_.rootSpeedCount() == 0 && contact_.isEmpty() && !integrator_);
  course_.setEvery(steps);
}

void RobotBody::place(const Pose2& pose, const JointArray<double>& angles) {
  TreeState tree = dynamics_.zeroState();
  const int root = dynamics_.rootPositionCount();
  for (std::size_t j = 0; j < model().jointCount(); ++j) {
    const std::vector<int>& hinges = model().actuators[j].coordinates;
    for (const int c : hinges) tree.q[root + c] = angles[j] + plan_->joint_zero[j];
    if (hinges.empty()) hands_[j] = angles[j];
  }
  setTree(tree);
  if (root == 0) return;
  const Vec3& n = plan_->ground_normal;
  const Eigen::Quaterniond upright = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), n) *
                                     Eigen::AngleAxisd(pose.theta, Vec3::UnitZ()) * levelSoles();
  tree.q.head<7>() << upright.w(), upright.x(), upright.y(), upright.z(), pose.x, pose.y, 0;
  setTree(tree);
  tree.q[6] = -lowestPoint() / n.z();
  setTree(tree);
  tree.q[6] += contact_.calcLift(motion());
  setTree(std::move(tree));
}

// The turn from the present attitude to one with both soles level on average.
Eigen::Quaterniond RobotBody::levelSoles() const {
  Vec3 up = Vec3::Zero();
  for (const FootModel& foot : model().feet) {
    up += motion()[static_cast<std::size_t>(foot.body)].R_WB * foot.X_BS.linear().col(2);
  }
  if (up.norm() < 1e-6) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond::FromTwoVectors(up, Vec3::UnitZ());
}

double RobotBody::angle(Joint joint) const {
  const bool hand = model().actuators[index(joint)].coordinates.empty();
  return hand ? hands_[joint] : drive_.angle()[joint];
}

void RobotBody::step(const JointCommand& command, const DriveTerms* terms,
                     const std::vector<ExternalForce>& external, double h) {
  if (integrator_) return stepSmoothly(command, external, h);
  followInertia();
  ended(Phase::Dynamics);
  drive_.prepare(command, coordinates(), rates(), h, terms);
  stops_.prepare(coordinates(), rates(), h);
  ended(Phase::Drives);
  contact_.prepare(motion(), dynamics_, h);
  ended(Phase::Ground);
  solve(external, h);
  ended(Phase::Solve);
  contact_.finish(motion());
  drive_.finish(du_);
  integrate(h);
  moveHands(command, h);
  moved();
  ended(Phase::Kinematics);
}

void RobotBody::stepSmoothly(const JointCommand& command,
                             const std::vector<ExternalForce>& external, double h) {
  smooth_.hold(command, external);
  integrator_->step(smooth_, h, tree_);
  moveHands(command, h);
  moved();
  contact_.settle(motion());
}

Eigen::VectorXd RobotBody::calcAcceleration(const JointCommand& command,
                                            const std::vector<ExternalForce>& external) {
  NAO_CHECK(integrator_);
  smooth_.hold(command, external);
  Eigen::VectorXd acceleration = integrator_->calcAcceleration(smooth_, tree_);
  dynamics_.setState(tree_);
  return acceleration;
}

void RobotBody::followInertia() {
  if (!course_.isDue()) return course_.goOn(inertia_, bias_);
  if (course_.every() > 1) dynamics_.setState(tree_);
  dynamics_.calcBias(plan_->gravity, bias_);
  needInertia();
  course_.take(inertia_, bias_);
}

void RobotBody::needInertia() {
  if (inertia_known_) return;
  dynamics_.calcMassMatrix(inertia_);
  inertia_.addDiagonal(drive_.rotorInertia());
  inertia_known_ = true;
}

void RobotBody::solve(const std::vector<ExternalForce>& external, double h) {
  addExternal(external, h);
  for (int solves = 1;; ++solves) {
    system_.takeEntries(inertia_);
    du_ = external_ - h * bias_;
    drive_.addTo(system_, du_);
    stops_.addTo(system_, du_);
    contact_.addTo(system_, du_);
    system_.factor();
    system_.solve(du_);
    tieSharedHinges(h);
    // Drives and stops first: contacts judged beside impossible torques would open for nothing.
    const bool drives_changed = drive_.revise(du_);
    const bool stops_changed = stops_.revise(du_);
    const bool joints_changed = drives_changed || stops_changed;
    const bool contacts_changed = contact_.revise(du_, !joints_changed);
    if (!(joints_changed || contacts_changed) || solves == kMaxSolves) return;
  }
}

void RobotBody::addExternal(const std::vector<ExternalForce>& external, double h) {
  external_.setZero();
  TreeDynamics::PointJacobian jacobian;
  for (const ExternalForce& force : external) {
    dynamics_.calcPointJacobian(force.body, force.p_W, jacobian);
    for (int axis = 0; axis < 3; ++axis) {
      system_.addScaled(jacobian.leaf, jacobian.row[axis], h * force.f_W[axis], external_);
    }
  }
}

// Hinges of one motor end the step at one angle.
void RobotBody::tieSharedHinges(double h) {
  const int root = dynamics_.rootSpeedCount();
  ties_.hold([this](Eigen::VectorXd& c) { system_.solve(c); },
             [&](int a, int b) {
               return (coordinates()[b - root] - coordinates()[a - root]) / h + tree_.u[b] -
                      tree_.u[a];
             },
             du_);
}

void RobotBody::integrate(double h) {
  tree_.u += du_;
  const int root_q = dynamics_.rootPositionCount();
  const int root_u = dynamics_.rootSpeedCount();
  if (root_q > 0) {
    tree_.q.head<4>() = rotated(tree_.q.head<4>(), tree_.u.head<3>(), h);
    tree_.q.segment<3>(4) += h * tree_.u.segment<3>(3);
  }
  const auto joints = tree_.u.size() - root_u;
  tree_.q.segment(root_q, joints) += h * tree_.u.segment(root_u, joints);
}

void RobotBody::moveHands(const JointCommand& command, double h) {
  for (std::size_t j = 0; j < model().jointCount(); ++j) {
    const Actuator& actuator = model().actuators[j];
    if (!actuator.coordinates.empty() || command.stiffness[j] <= 0) continue;
    const double reach = actuator.max_velocity * h;
    hands_[j] += std::clamp(command.angle[j] - hands_[j], -reach, reach);
  }
}

void RobotBody::moved() {
  if (course_.every() == 1 || !course_.isKnown()) dynamics_.setState(tree_);
  drive_.observe(coordinates(), rates());
  inertia_known_ = mobility_known_ = false;
}

void RobotBody::needMobility() {
  if (mobility_known_) return;
  needInertia();
  mobility_.takeEntries(inertia_);
  mobility_.factor();
  mobility_known_ = true;
}

void RobotBody::addPush(int body, const Vec3& p_W, const Vec3& j_W, Eigen::VectorXd& push) const {
  TreeDynamics::PointJacobian jacobian;
  dynamics_.calcPointJacobian(body, p_W, jacobian);
  for (int axis = 0; axis < 3; ++axis) {
    inertia_.addScaled(jacobian.leaf, jacobian.row[axis], j_W[axis], push);
  }
}

void RobotBody::respond(Eigen::VectorXd& push) {
  needMobility();
  mobility_.solve(push);
}

void RobotBody::archive(Archive& archive) {
  archive.numbers(tree_.q);
  archive.numbers(tree_.u);
  archive.value(hands_);
  drive_.archive(archive);
  contact_.archive(archive);
  if (archive.mode() == Archive::Mode::Load) moved();
}

}  // namespace nao::sim
