#include "sim/tree_dynamics.h"

#include <cmath>

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

// The rotation R turned about its own x, y or z axis: two columns mix.
void turnColumns(const Mat3& R, int from, int to, double angle, Mat3& out) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const Vec3 a = R.col(from);
  const Vec3 b = R.col(to);
  out.col(3 - from - to) = R.col(3 - from - to);
  out.col(from) = c * a + s * b;
  out.col(to) = c * b - s * a;
}

// Eigen's own product of two such is a call.
void multiply(const Mat3& a, const Mat3& b, Mat3& out) {
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) {
      out(r, c) = a(r, 0) * b(0, c) + a(r, 1) * b(1, c) + a(r, 2) * b(2, c);
    }
  }
}

inline Vec3 times(const double* s, const Vec3& w) {  // symmetric: xx yy zz xy xz yz
  return {s[0] * w.x() + s[3] * w.y() + s[4] * w.z(), s[3] * w.x() + s[1] * w.y() + s[5] * w.z(),
          s[4] * w.x() + s[5] * w.y() + s[2] * w.z()};
}

}  // namespace

TreeDynamics::TreeDynamics(const RobotModel& model)
    : root_speeds_(model.fixed_base ? 0 : 6),
      parents_(speedParents(model, root_speeds_)),
      moving_(model.bodies.size()),
      motion_(model.bodies.size()) {
  NAO_CHECK(parents_.size() <= kMaxDepth);
  for (const Body& body : model.bodies) {
    links_.push_back(makeLink(body));
    mass_ += body.mass;
  }
}

TreeDynamics::Link TreeDynamics::makeLink(const Body& body) {
  Link link{};
  link.parent = body.parent;
  link.R_PB = body.X_PB.linear();
  link.p_PB = body.X_PB.translation();
  link.aligned = link.R_PB.isIdentity(0);
  link.axis_B = body.axis;
  link.axis = body.axis == Vec3::UnitX()   ? Link::Axis::X
              : body.axis == Vec3::UnitY() ? Link::Axis::Y
              : body.axis == Vec3::UnitZ() ? Link::Axis::Z
                                           : Link::Axis::Any;
  link.mass = body.mass;
  link.com_B = body.p_BoBcm;
  link.inertia_B = body.I_Bcm;
  return link;
}

TreeState TreeDynamics::zeroState() const {
  const int speeds = speedCount();
  TreeState state{Eigen::VectorXd::Zero(speeds + rootPositionCount() - root_speeds_),
                  Eigen::VectorXd::Zero(speeds)};
  if (root_speeds_ > 0) state.q[0] = 1;
  return state;
}

void TreeDynamics::setDamping(double linear, double angular) {
  linear_damping_ = linear;
  angular_damping_ = angular;
}

void TreeDynamics::setState(const TreeState& state) {
  BodyMotion& root = motion_[0];
  if (root_speeds_ > 0) {
    root.R_WB = Eigen::Quaterniond(state.q[0], state.q[1], state.q[2], state.q[3])
                    .normalized()
                    .toRotationMatrix();
    root.p_WB = state.q.segment<3>(4);
    root.w_WB = state.u.head<3>();
    root.v_WB = state.u.segment<3>(3);
  } else {
    root.R_WB = links_[0].R_PB;
    root.p_WB = links_[0].p_PB;
  }
  moving_[0].arm.setZero();
  takeInertia(0);
  const double* angles = state.q.data() + rootPositionCount();
  const double* rates = state.u.data() + root_speeds_;
  for (std::size_t i = 1; i < links_.size(); ++i) placeChild(i, angles[i - 1], rates[i - 1]);
}

void TreeDynamics::placeChild(std::size_t i, double angle, double rate) {
  const Link& link = links_[i];
  const auto p = static_cast<std::size_t>(link.parent);
  const BodyMotion& parent = motion_[p];
  BodyMotion& body = motion_[i];
  Mat3 turned;
  if (!link.aligned) multiply(parent.R_WB, link.R_PB, turned);
  const Mat3& R = link.aligned ? parent.R_WB : turned;
  switch (link.axis) {
    case Link::Axis::X:
      turnColumns(R, 1, 2, angle, body.R_WB);
      break;
    case Link::Axis::Y:
      turnColumns(R, 2, 0, angle, body.R_WB);
      break;
    case Link::Axis::Z:
      turnColumns(R, 0, 1, angle, body.R_WB);
      break;
    case Link::Axis::Any:
      multiply(R, Eigen::AngleAxisd(angle, link.axis_B).toRotationMatrix(), body.R_WB);
      break;
  }
  Moving& moving = moving_[i];
  const Vec3 r = parent.R_WB * link.p_PB;
  body.p_WB = parent.p_WB + r;
  moving.arm = moving_[p].arm + r;
  moving.axis = body.R_WB * link.axis_B;
  moving.lever = moving.arm.cross(moving.axis);
  moving.rate = rate;
  body.w_WB = parent.w_WB + rate * moving.axis;
  body.v_WB = parent.v_WB + parent.w_WB.cross(r);
  takeInertia(i);
}

void TreeDynamics::takeInertia(std::size_t i) {
  const Link& link = links_[i];
  const Mat3& R = motion_[i].R_WB;
  Moving& moving = moving_[i];
  moving.com = moving.arm + R * link.com_B;
  Mat3 RI;
  multiply(R, link.inertia_B, RI);
  double* central = moving.central;
  central[0] = RI.row(0).dot(R.row(0));
  central[1] = RI.row(1).dot(R.row(1));
  central[2] = RI.row(2).dot(R.row(2));
  central[3] = RI.row(0).dot(R.row(1));
  central[4] = RI.row(0).dot(R.row(2));
  central[5] = RI.row(1).dot(R.row(2));
  const Vec3& c = moving.com;
  const double m = link.mass;
  SpatialInertia& own = moving.own;
  own.mass = m;
  own.moment = m * c;
  own.inertia[0] = central[0] + m * (c.y() * c.y() + c.z() * c.z());
  own.inertia[1] = central[1] + m * (c.x() * c.x() + c.z() * c.z());
  own.inertia[2] = central[2] + m * (c.x() * c.x() + c.y() * c.y());
  own.inertia[3] = central[3] - m * c.x() * c.y();
  own.inertia[4] = central[4] - m * c.x() * c.z();
  own.inertia[5] = central[5] - m * c.y() * c.z();
}

void TreeDynamics::calcBias(double gravity, Eigen::VectorXd& bias) {
  bias.resize(speedCount());
  for (std::size_t i = 0; i < links_.size(); ++i) {
    Moving& m = moving_[i];
    const BodyMotion& body = motion_[i];
    if (i == 0) {
      m.alpha.setZero();
      m.acceleration = Vec3(0, 0, gravity);  // standing still under gravity is being pushed up
    } else {
      const auto p = static_cast<std::size_t>(links_[i].parent);
      const Vec3& w = motion_[p].w_WB;
      const Vec3 r = m.arm - moving_[p].arm;
      m.alpha = moving_[p].alpha + w.cross(m.rate * m.axis);
      m.acceleration = moving_[p].acceleration + moving_[p].alpha.cross(r) + w.cross(w.cross(r));
    }
    const Vec3& w = body.w_WB;
    const Vec3 c = m.com - m.arm;
    const Vec3 wc = w.cross(c);
    Vec3 a = m.acceleration + m.alpha.cross(c) + w.cross(wc);
    a += linear_damping_ * (body.v_WB + wc);
    m.force = links_[i].mass * a;
    m.moment = times(m.central, m.alpha + angular_damping_ * w) + w.cross(times(m.central, w)) +
               m.com.cross(m.force);
  }
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    const Moving& m = moving_[i];
    bias[root_speeds_ + static_cast<int>(i) - 1] = m.axis.dot(m.moment) + m.lever.dot(m.force);
    Moving& parent = moving_[static_cast<std::size_t>(links_[i].parent)];
    parent.force += m.force;
    parent.moment += m.moment;
  }
  if (root_speeds_ > 0) {
    bias.head<3>() = moving_[0].moment;
    bias.segment<3>(3) = moving_[0].force;
  }
}

void TreeDynamics::calcMassMatrix(TreeMatrix& matrix) {
  for (Moving& moving : moving_) moving.composite = moving.own;
  for (std::size_t i = links_.size() - 1; i > 0; --i) {
    addColumn(matrix, i);
    const SpatialInertia& child = moving_[i].composite;
    SpatialInertia& parent = moving_[static_cast<std::size_t>(links_[i].parent)].composite;
    parent.mass += child.mass;
    parent.moment += child.moment;
    for (int k = 0; k < 6; ++k) parent.inertia[k] += child.inertia[k];
  }
  if (root_speeds_ > 0) addRoot(matrix);
}

// The momentum of the subtree per unit of the hinge's rate, as every speed above it sees it.
void TreeDynamics::addColumn(TreeMatrix& matrix, std::size_t body) const {
  const Moving& m = moving_[body];
  const SpatialInertia& c = m.composite;
  const Vec3 angular = times(c.inertia, m.axis) + c.moment.cross(m.lever);
  const Vec3 linear = c.mass * m.lever - c.moment.cross(m.axis);
  double* row = matrix.row(root_speeds_ + static_cast<int>(body) - 1);
  for (int b = static_cast<int>(body); b > 0; b = links_[static_cast<std::size_t>(b)].parent) {
    const Moving& above = moving_[static_cast<std::size_t>(b)];
    row[root_speeds_ + b - 1] = above.axis.dot(angular) + above.lever.dot(linear);
  }
  if (root_speeds_ == 0) return;
  for (int i = 0; i < 3; ++i) {
    row[i] = angular[i];
    row[i + 3] = linear[i];
  }
}

void TreeDynamics::addRoot(TreeMatrix& matrix) const {
  const SpatialInertia& c = moving_[0].composite;
  const double* I = c.inertia;
  const Vec3& m = c.moment;
  const double lower[6][6] = {{I[0]},
                              {I[3], I[1]},
                              {I[4], I[5], I[2]},
                              {0, m.z(), -m.y(), c.mass},
                              {-m.z(), 0, m.x(), 0, c.mass},
                              {m.y(), -m.x(), 0, 0, 0, c.mass}};
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column <= row; ++column) matrix.at(row, column) = lower[row][column];
  }
}

void TreeDynamics::calcPointJacobian(int body, const Vec3& p_W, PointJacobian& jacobian) const {
  const Vec3 arm = p_W - motion_[0].p_WB;
  jacobian.leaf = leafOf(body);
  int count = root_speeds_;
  for (int b = body; b > 0; b = links_[static_cast<std::size_t>(b)].parent) ++count;
  jacobian.count = count;
  for (int b = body; b > 0; b = links_[static_cast<std::size_t>(b)].parent) {
    const Moving& m = moving_[static_cast<std::size_t>(b)];
    const Vec3 v = m.axis.cross(arm - m.arm);
    jacobian.speed[--count] = leafOf(b);
    for (int axis = 0; axis < 3; ++axis) jacobian.row[axis][count] = v[axis];
  }
  if (root_speeds_ == 0) return;
  const double root[3][6] = {{0, arm.z(), -arm.y(), 1, 0, 0},
                             {-arm.z(), 0, arm.x(), 0, 1, 0},
                             {arm.y(), -arm.x(), 0, 0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 6; ++i) jacobian.row[axis][i] = root[axis][i];
  }
  for (int i = 0; i < 6; ++i) jacobian.speed[i] = i;
}

TreeDynamics::Spatial TreeDynamics::calcBodyVelocity(const Eigen::VectorXd& u, int body) const {
  Spatial v = Spatial::Zero();
  if (root_speeds_ > 0) v = u.head<6>();
  for (int b = body; b > 0; b = links_[static_cast<std::size_t>(b)].parent) {
    const Moving& m = moving_[static_cast<std::size_t>(b)];
    const double rate = u[leafOf(b)];
    v.head<3>() += rate * m.axis;
    v.tail<3>() += rate * m.lever;
  }
  return v;
}

void TreeDynamics::addBodyWrench(int body, const Spatial& w, Eigen::VectorXd& rhs) const {
  for (int b = body; b > 0; b = links_[static_cast<std::size_t>(b)].parent) {
    const Moving& m = moving_[static_cast<std::size_t>(b)];
    rhs[leafOf(b)] += m.axis.dot(w.head<3>()) + m.lever.dot(w.tail<3>());
  }
  if (root_speeds_ > 0) rhs.head<6>() += w;
}

void TreeDynamics::addBodyStiffness(int body, const SpatialMatrix& K, TreeMatrix& matrix) const {
  for (int i = body; i > 0; i = links_[static_cast<std::size_t>(i)].parent) {
    const Moving& own = moving_[static_cast<std::size_t>(i)];
    Spatial hinge;
    hinge << own.axis, own.lever;
    const Spatial f = K * hinge;
    const Vec3 moment = f.head<3>();
    const Vec3 force = f.tail<3>();
    double* row = matrix.row(leafOf(i));
    for (int j = i; j > 0; j = links_[static_cast<std::size_t>(j)].parent) {
      const Moving& above = moving_[static_cast<std::size_t>(j)];
      row[leafOf(j)] += above.axis.dot(moment) + above.lever.dot(force);
    }
    for (int k = 0; k < root_speeds_; ++k) row[k] += f[k];
  }
  for (int r = 0; r < root_speeds_; ++r) {
    for (int c = 0; c <= r; ++c) matrix.at(r, c) += K(r, c);
  }
}

}  // namespace nao::sim
