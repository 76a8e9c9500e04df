#include "sim/ground_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nao::sim {
namespace {

constexpr double kSlowSliding = 0.02;  // [m/s] free choice: a Nao's feet stick or slide faster

// The corners of a sole's outline: its farthest points along the four diagonals.
std::array<Eigen::Vector2d, 4> cornersOf(const std::vector<Eigen::Vector2d>& outline) {
  std::array<Eigen::Vector2d, 4> corners;
  const std::array<Eigen::Vector2d, 4> diagonals{{{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    corners[i] = *std::max_element(outline.begin(), outline.end(), [&](auto& a, auto& b) {
      return a.dot(diagonals[i]) < b.dot(diagonals[i]);
    });
  }
  return corners;
}

}  // namespace

GroundContact::GroundContact(const RobotModel& model, const Material& material)
    : material_(material) {
  for (std::size_t i = 0; i < model.feet.size(); ++i) addFoot(model.feet[i], static_cast<int>(i));
  for (const ContactSphere& sphere : model.contact_spheres) {
    points_.push_back({sphere.body, -1, sphere.p_B, sphere.radius});
  }
  anchors_.resize(points_.size());
  touches_.resize(points_.size());
  forces_.reserve(points_.size());
}

void GroundContact::addFoot(const FootModel& foot, int index) {
  for (const Eigen::Vector2d& corner : cornersOf(foot.outline)) {
    points_.push_back({foot.body, index, foot.X_BS * Vec3(corner.x(), corner.y(), 0), 0});
  }
}

void GroundContact::reset() {
  std::fill(anchors_.begin(), anchors_.end(), Anchor());
  forces_.clear();
}

void GroundContact::archive(Archive& archive) {
  for (Anchor& anchor : anchors_) {
    archive.value(anchor.touching);
    archive.value(anchor.sliding);
    archive.value(anchor.load);
    archive.numbers(anchor.place);
  }
  auto count = static_cast<std::uint64_t>(forces_.size());
  archive.value(count);
  if (archive.mode() == Archive::Mode::Load) forces_.resize(static_cast<std::size_t>(count));
  for (Force& force : forces_) {
    archive.value(force.body);
    archive.value(force.foot);
    archive.numbers(force.p_B);
    archive.numbers(force.f_W);
    archive.value(force.depth);
  }
}

double GroundContact::lowestPoint(const std::vector<BodyMotion>& motion) const {
  double lowest = std::numeric_limits<double>::max();
  for (const Point& point : points_) {
    const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
    lowest = std::min(lowest, (body.p_WB + body.R_WB * point.p_B).z() - point.radius);
  }
  return points_.empty() ? 0 : lowest;
}

void GroundContact::prepare(const std::vector<BodyMotion>& motion, const TreeDynamics& mass,
                            double h) {
  h_ = h;
  mass_ = &mass;
  touch_count_ = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Point& point = points_[i];
    const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
    Vec3 arm = body.R_WB * point.p_B;
    arm.z() -= point.radius;
    const Vec3 p_W = body.p_WB + arm;
    const Vec3 v_W = body.v_WB + body.w_WB.cross(arm);
    if (std::min(p_W.z(), p_W.z() + h * v_W.z()) < 0) {
      open(i, p_W, v_W);
    } else {
      anchors_[i].touching = false;
    }
  }
}

void GroundContact::open(std::size_t point, const Vec3& p_W, const Vec3& v_W) {
  Touch& touch = touches_[touch_count_++];
  touch.point = point;
  touch.p_W = p_W;
  touch.v = v_W;
  touch.direction = Eigen::Vector2d::UnitX();
  mass_->calcPointJacobian(points_[point].body, p_W, touch.jacobian);
  Anchor& anchor = anchors_[point];
  if (!anchor.touching) anchor = {true, false, 0, p_W.head<2>()};
  stick(touch);
  if (anchor.sliding && v_W.head<2>().norm() > kSlowSliding) slide(touch, anchor.load);
}

// Turns the horizontal axes of a touch, so that sliding is along its first.
void GroundContact::turnTo(Touch& touch, const Eigen::Vector2d& direction) const {
  touch.direction = direction;
  const double c = direction.x();
  const double s = direction.y();
  for (int i = 0; i < touch.jacobian.count; ++i) {
    double& x = touch.jacobian.row[0][i];
    double& y = touch.jacobian.row[1][i];
    const double along = c * x + s * y;
    y = c * y - s * x;
    x = along;
  }
  touch.v.head<2>() =
      Eigen::Vector2d(c * touch.v.x() + s * touch.v.y(), c * touch.v.y() - s * touch.v.x());
}

Vec3 GroundContact::toWorld(const Touch& touch, const Vec3& v) {
  const double c = touch.direction.x();
  const double s = touch.direction.y();
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
}

void GroundContact::stick(Touch& touch) const {
  const Material& m = material_;
  touch.mode = Mode::Stick;
  const Eigen::Vector2d stretch = touch.p_W.head<2>() - anchors_[touch.point].place;
  const Vec3 next = Vec3(stretch.x(), stretch.y(), touch.p_W.z()) + h_ * touch.v;
  const Vec3 k(m.tangential_stiffness, m.tangential_stiffness, m.stiffness);
  const Vec3 d(m.tangential_damping, m.tangential_damping, m.damping);
  touch.now = -k.cwiseProduct(next) - d.cwiseProduct(touch.v);
  touch.change = h_ * k + d;
}

// mu f_n against the motion: constant along it, and turning with it as the motion turns.
void GroundContact::slide(Touch& touch, double load) const {
  const double speed = touch.v.head<2>().norm();
  const double friction = material_.friction * load;
  touch.mode = Mode::Slide;
  if (speed < kSlowSliding) {
    touch.now.head<2>() = -friction / kSlowSliding * touch.v.head<2>();
    touch.change.head<2>().setConstant(friction / kSlowSliding);
    touch.mode = Mode::Brake;
    return;
  }
  turnTo(touch, touch.v.head<2>() / speed);
  touch.now.head<2>() = Eigen::Vector2d(-friction, 0);
  touch.change.head<2>() = Eigen::Vector2d(0, friction / speed);
}

// The same force, falling to nothing as the point comes to rest: it never turns back.
void GroundContact::brake(Touch& touch) const {
  touch.mode = Mode::Brake;
  touch.change.x() = -touch.now.x() / touch.v.x();
}

void GroundContact::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const {
  for (std::size_t t = 0; t < touch_count_; ++t) {
    const Touch& touch = touches_[t];
    if (touch.mode == Mode::Open) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double* row = touch.jacobian.row[axis];
      matrix.addOuterProduct(touch.jacobian.leaf, row, h_ * touch.change[axis]);
      matrix.addScaled(touch.jacobian.leaf, row, h_ * touch.now[axis], rhs);
    }
  }
}

Vec3 GroundContact::velocityChange(const Touch& touch, const Eigen::VectorXd& du) const {
  const TreeDynamics::PointJacobian& jacobian = touch.jacobian;
  Vec3 change = Vec3::Zero();
  for (int k = 0; k < jacobian.count; ++k) {
    const double speed = du[jacobian.speed[k]];
    for (int axis = 0; axis < 3; ++axis) change[axis] += jacobian.row[axis][k] * speed;
  }
  return change;
}

bool GroundContact::revise(const Eigen::VectorXd& du, bool may_open) {
  bool changed = false;
  for (std::size_t t = 0; t < touch_count_; ++t) {
    Touch& touch = touches_[t];
    if (touch.mode == Mode::Open) continue;
    const Vec3 change = velocityChange(touch, du);
    touch.force = touch.now - touch.change.cwiseProduct(change);
    changed |= !keepsFriction(touch, touch.v.x() + change.x());
  }
  if (changed || !may_open) return changed;
  for (std::size_t t = 0; t < touch_count_; ++t) {
    Touch& touch = touches_[t];
    if (touch.mode == Mode::Open || touch.force.z() >= 0) continue;
    touch.mode = Mode::Open;
    touch.force.setZero();
    changed = true;
  }
  return changed;
}

// `speed_after` [m/s] is along the touch's first axis at the end of the step.
bool GroundContact::keepsFriction(Touch& touch, double speed_after) const {
  const double load = std::max(0.0, touch.force.z());
  if (touch.mode == Mode::Stick) {
    if (touch.force.head<2>().norm() <= material_.friction * load) return true;
    slide(touch, load);
    return false;
  }
  if (touch.mode != Mode::Slide || speed_after >= 0) return true;
  brake(touch);
  return false;
}

void GroundContact::finish(const Eigen::VectorXd& du) {
  forces_.clear();
  for (std::size_t t = 0; t < touch_count_; ++t) {
    const Touch& touch = touches_[t];
    Anchor& anchor = anchors_[touch.point];
    anchor.touching = touch.mode != Mode::Open;
    if (!anchor.touching) continue;
    const Vec3 f_W = toWorld(touch, touch.force);
    anchor.load = std::max(0.0, f_W.z());
    anchor.sliding = touch.mode != Mode::Stick;
    if (anchor.sliding) {
      const Vec3 v_W = toWorld(touch, touch.v + velocityChange(touch, du));
      anchor.place =
          touch.p_W.head<2>() + h_ * v_W.head<2>() + f_W.head<2>() / material_.tangential_stiffness;
    }
    const Point& point = points_[touch.point];
    forces_.push_back({point.body, point.foot, point.p_B, f_W, -touch.p_W.z()});
  }
}

}  // namespace nao::sim
