#include "sim/tree_dynamics.h"

#include "core/check.h"

namespace nao::sim {
namespace {

std::vector<int> speedParents(const RobotModel& model, int root_speeds) {
  std::vector<int> parents;
  for (int i = 0; i < root_speeds; ++i) parents.push_back(i - 1);
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    const int parent = model.bodies[i].parent;
    parents.push_back(parent == 0 ? root_speeds - 1 : root_speeds + parent - 1);
  }
  return parents;
}

}  // namespace

TreeDynamics::TreeDynamics(const RobotModel& model)
    : model_(model),
      root_speeds_(model.fixed_base ? 0 : 6),
      parents_(speedParents(model, root_speeds_)),
      axes_W_(model.bodies.size()),
      arms_W_(model.bodies.size()),
      composites_(model.bodies.size()) {
  NAO_CHECK(parents_.size() <= kMaxDepth);
}

void TreeDynamics::setMotion(const std::vector<BodyMotion>& motion) {
  motion_ = &motion;
  for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
    axes_W_[i] = motion[i].R_WB * model_.bodies[i].axis;
    arms_W_[i] = motion[i].p_WB - motion[0].p_WB;
  }
}

TreeDynamics::SpatialInertia TreeDynamics::inertiaOf(std::size_t i) const {
  const Body& body = model_.bodies[i];
  const Mat3& R = (*motion_)[i].R_WB;
  const Vec3 com = arms_W_[i] + R * body.p_BoBcm;
  SpatialInertia out;
  out.mass = body.mass;
  out.moment = body.mass * com;
  out.inertia = R * body.I_Bcm * R.transpose() +
                body.mass * (com.squaredNorm() * Mat3::Identity() - com * com.transpose());
  return out;
}

void TreeDynamics::calc(TreeMatrix& matrix) const {
  const std::size_t count = model_.bodies.size();
  for (std::size_t i = 0; i < count; ++i) composites_[i] = inertiaOf(i);
  for (std::size_t i = count - 1; i > 0; --i) {
    const SpatialInertia& child = composites_[i];
    addJoint(matrix, leafOf(static_cast<int>(i)), child);
    SpatialInertia& parent = composites_[static_cast<std::size_t>(model_.bodies[i].parent)];
    parent.mass += child.mass;
    parent.moment += child.moment;
    parent.inertia += child.inertia;
  }
  if (root_speeds_ > 0) addRoot(matrix, composites_[0]);
}

// The momentum of the subtree per unit of this speed, seen by every speed below it.
void TreeDynamics::addJoint(TreeMatrix& matrix, int speed, const SpatialInertia& c) const {
  const auto body = static_cast<std::size_t>(speed - root_speeds_ + 1);
  const Vec3& w = axes_W_[body];
  const Vec3 v = arms_W_[body].cross(w);  // of the point of the subtree at the root's origin
  const Vec3 angular = c.inertia * w + c.moment.cross(v);
  const Vec3 linear = c.mass * v - c.moment.cross(w);
  int i = speed;
  for (; i >= root_speeds_; i = matrix.parent(i)) {
    const auto b = static_cast<std::size_t>(i - root_speeds_ + 1);
    matrix.at(speed, i) = axes_W_[b].dot(angular) + arms_W_[b].cross(axes_W_[b]).dot(linear);
  }
  for (; i >= 0; --i) matrix.at(speed, i) = i < 3 ? angular[i] : linear[i - 3];
}

void TreeDynamics::addRoot(TreeMatrix& matrix, const SpatialInertia& c) const {
  Mat3 moment_cross;
  moment_cross << 0, -c.moment.z(), c.moment.y(), c.moment.z(), 0, -c.moment.x(), -c.moment.y(),
      c.moment.x(), 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column <= row; ++column) {
      matrix.at(row, column) = c.inertia(row, column);
      matrix.at(row + 3, column + 3) = row == column ? c.mass : 0;
    }
    for (int column = 0; column < 3; ++column) {
      matrix.at(row + 3, column) = -moment_cross(row, column);
    }
  }
}

// The weight of the subtree behind each hinge, and its moment about the root's origin.
void TreeDynamics::addWeight(double gravity, Eigen::VectorXd& bias) const {
  for (std::size_t i = 0; i < composites_.size(); ++i) {
    const SpatialInertia& c = composites_[i];
    const Vec3 lift(0, 0, gravity * c.mass);
    const Vec3 moment = gravity * c.moment.cross(Vec3::UnitZ());
    if (i > 0) {
      bias[leafOf(static_cast<int>(i))] +=
          axes_W_[i].dot(moment) + arms_W_[i].cross(axes_W_[i]).dot(lift);
    } else if (root_speeds_ > 0) {
      bias.head<3>() += moment;
      bias.segment<3>(3) += lift;
    }
  }
}

void TreeDynamics::calcPointJacobian(int body, const Vec3& p_W, PointJacobian& jacobian) const {
  const Vec3 arm = p_W - (*motion_)[0].p_WB;
  int count = 0;
  for (int b = body; b > 0; b = model_.bodies[static_cast<std::size_t>(b)].parent, ++count) {
    const auto i = static_cast<std::size_t>(b);
    const Vec3 v = axes_W_[i].cross(arm - arms_W_[i]);
    for (int axis = 0; axis < 3; ++axis) jacobian.row[axis][count] = v[axis];
  }
  for (int i = root_speeds_ - 1; i >= 0; --i, ++count) {
    const Vec3 v = i < 3 ? Vec3(Vec3::Unit(i).cross(arm)) : Vec3(Vec3::Unit(i - 3));
    for (int axis = 0; axis < 3; ++axis) jacobian.row[axis][count] = v[axis];
  }
  jacobian.leaf = leafOf(body);
  jacobian.count = count;
}

}  // namespace nao::sim
