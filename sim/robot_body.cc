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

RobotBody::RobotBody(std::shared_ptr<const RobotModel> model, const WorldModel& world)
    : model_(std::move(model)),
      gravity_(world.gravity),
      multibody_(*model_, world.gravity),
      mass_(*model_),
      drive_(*model_, multibody_.rootSpeedCount()),
      stops_(*model_, multibody_.rootSpeedCount()),
      contact_(*model_, world.ground),
      inertia_(mass_.parents()),
      system_(mass_.parents()),
      external_(Eigen::VectorXd::Zero(multibody_.speedCount())) {
  place({}, JointArray<double>(model_->jointCount()));
}

void RobotBody::setState(State state) {
  state_ = std::move(state);
  contact_.anchors() = state_.anchors;
  updateMotion();
}

void RobotBody::place(const Pose2& pose, const JointArray<double>& angles) {
  State state{multibody_.zeroState(), {}, JointArray<double>(model_->jointCount())};
  state.anchors.resize(contact_.anchors().size());
  const int root = multibody_.rootPositionCount();
  for (std::size_t j = 0; j < model_->jointCount(); ++j) {
    for (const int c : model_->actuators[j].coordinates) state.tree.q[root + c] = angles[j];
    if (model_->actuators[j].coordinates.empty()) state.hands[j] = angles[j];
  }
  setState(state);
  if (root == 0) return;
  const Eigen::Quaterniond upright = Eigen::AngleAxisd(pose.theta, Vec3::UnitZ()) * levelSoles();
  state.tree.q.head<7>() << upright.w(), upright.x(), upright.y(), upright.z(), pose.x, pose.y, 0;
  setState(state);
  state.tree.q[6] = -contact_.lowestPoint(motion_);
  setState(std::move(state));
}

// The turn from the present attitude to one with both soles level on average.
Eigen::Quaterniond RobotBody::levelSoles() const {
  Vec3 up = Vec3::Zero();
  for (const FootModel& foot : model_->feet) {
    up += motion_[static_cast<std::size_t>(foot.body)].R_WB * foot.X_BS.linear().col(2);
  }
  if (up.norm() < 1e-6) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond::FromTwoVectors(up, Vec3::UnitZ());
}

const double* RobotBody::coordinates() const {
  return state_.tree.q.data() + multibody_.rootPositionCount();
}
const double* RobotBody::rates() const {
  return state_.tree.u.data() + multibody_.rootSpeedCount();
}

double RobotBody::angle(Joint joint) const {
  const std::vector<int>& c = model_->actuators[index(joint)].coordinates;
  return c.empty() ? state_.hands[joint] : coordinates()[c.front()];
}

double RobotBody::rate(Joint joint) const {
  const std::vector<int>& c = model_->actuators[index(joint)].coordinates;
  return c.empty() ? 0 : rates()[c.front()];
}

bool RobotBody::finite() const { return state_.tree.q.allFinite() && state_.tree.u.allFinite(); }

void RobotBody::step(const JointCommand& command, const std::vector<ExternalForce>& external,
                     double h) {
  multibody_.calcVelocityBias(bias_);
  mass_.calc(inertia_);
  mass_.addWeight(gravity_, bias_);
  inertia_.addDiagonal(drive_.rotorInertia());
  drive_.prepare(command, coordinates(), rates(), h);
  stops_.prepare(coordinates(), rates(), h);
  contact_.prepare(motion_, mass_, h);
  solve(external, h);
  contact_.finish(du_);
  state_.anchors = contact_.anchors();
  integrate(h);
  moveHands(command, h);
  updateMotion();
}

void RobotBody::solve(const std::vector<ExternalForce>& external, double h) {
  external_.setZero();
  addExternal(external, h);
  for (solves_ = 1;; ++solves_) {
    system_ = inertia_;
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
    if (!(joints_changed || contacts_changed) || solves_ == kMaxSolves) return;
  }
}

void RobotBody::addExternal(const std::vector<ExternalForce>& external, double h) {
  TreeDynamics::PointJacobian jacobian;
  for (const ExternalForce& force : external) {
    mass_.calcPointJacobian(force.body, force.p_W, jacobian);
    int k = 0;
    for (int i = jacobian.leaf; i >= 0; i = system_.parent(i), ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        external_[i] += h * force.f_W[axis] * jacobian.row[axis][k];
      }
    }
  }
}

// Hinges of one motor end the step at one angle: the impulse between them that does so.
void RobotBody::tieSharedHinges(double h) {
  for (const Actuator& actuator : model_->actuators) {
    for (std::size_t i = 1; i < actuator.coordinates.size(); ++i) {
      const int a = actuator.coordinates.front();
      const int b = actuator.coordinates[i];
      const int speed_a = multibody_.rootSpeedCount() + a;
      const int speed_b = multibody_.rootSpeedCount() + b;
      tie_.setZero(du_.size());
      tie_[speed_a] = 1;
      tie_[speed_b] = -1;
      system_.solve(tie_);
      const double gap = (coordinates()[a] - coordinates()[b]) / h + rates()[a] - rates()[b] +
                         du_[speed_a] - du_[speed_b];
      du_ -= gap / (tie_[speed_a] - tie_[speed_b]) * tie_;
    }
  }
}

void RobotBody::integrate(double h) {
  TreeState& tree = state_.tree;
  tree.u += du_;
  const int root_q = multibody_.rootPositionCount();
  const int root_u = multibody_.rootSpeedCount();
  if (root_q > 0) {
    tree.q.head<4>() = rotated(tree.q.head<4>(), tree.u.head<3>(), h);
    tree.q.segment<3>(4) += h * tree.u.segment<3>(3);
  }
  const auto joints = tree.u.size() - root_u;
  tree.q.segment(root_q, joints) += h * tree.u.segment(root_u, joints);
}

void RobotBody::moveHands(const JointCommand& command, double h) {
  for (std::size_t j = 0; j < model_->jointCount(); ++j) {
    const Actuator& actuator = model_->actuators[j];
    if (!actuator.coordinates.empty() || command.stiffness[j] <= 0) continue;
    const double reach = actuator.max_velocity * h;
    state_.hands[j] += std::clamp(command.angle[j] - state_.hands[j], -reach, reach);
  }
}

void RobotBody::updateMotion() {
  multibody_.setState(state_.tree);
  multibody_.calcMotion(motion_);
  mass_.setMotion(motion_);
}

}  // namespace nao::sim
