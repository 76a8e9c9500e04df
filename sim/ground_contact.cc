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

double GroundContact::lowestPoint(const std::vector<BodyMotion>& motion) const {
  double lowest = std::numeric_limits<double>::max();
  for (const Point& point : points_) {
    const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
    lowest = std::min(lowest, (body.p_WB + body.R_WB * point.p_B).z() - point.radius);
  }
  return points_.empty() ? 0 : lowest;
}

void GroundContact::prepare(const std::vector<BodyMotion>& motion, const MassMatrix& mass,
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
  touch.v_W = v_W;
  if (!anchors_[point].touching) anchors_[point] = {true, p_W.head<2>()};
  mass_->calcPointJacobian(points_[point].body, p_W, touch.jacobian);
  stick(touch);
}

void GroundContact::stick(Touch& touch) const {
  const Material& m = material_;
  touch.mode = Mode::Stick;
  const Eigen::Vector2d stretch = touch.p_W.head<2>() - anchors_[touch.point].place;
  const Vec3 next = Vec3(stretch.x(), stretch.y(), touch.p_W.z()) + h_ * touch.v_W;
  const Vec3 k(m.tangential_stiffness, m.tangential_stiffness, m.stiffness);
  const Vec3 d(m.tangential_damping, m.tangential_damping, m.damping);
  touch.now = -k.cwiseProduct(next) - d.cwiseProduct(touch.v_W);
  touch.change = h_ * k + d;
}

void GroundContact::slide(Touch& touch, double normal_force) const {
  touch.mode = Mode::Slide;
  const double speed = std::max(touch.v_W.head<2>().norm(), kSlowSliding);
  const double drag = material_.friction * normal_force / speed;
  touch.now.head<2>() = -drag * touch.v_W.head<2>();
  touch.change.head<2>().setConstant(drag);
}

void GroundContact::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const {
  for (std::size_t t = 0; t < touch_count_; ++t) {
    const Touch& touch = touches_[t];
    if (touch.mode == Mode::Open) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const double* row = touch.jacobian.row[axis];
      matrix.addOuterProduct(touch.jacobian.leaf, row, h_ * touch.change[axis]);
      const double impulse = h_ * touch.now[axis];
      for (int i = touch.jacobian.leaf; i >= 0; i = matrix.parent(i)) rhs[i] += impulse * *row++;
    }
  }
}

Vec3 GroundContact::velocityChange(const Touch& touch, const std::vector<int>& parents,
                                   const Eigen::VectorXd& du) {
  Vec3 change = Vec3::Zero();
  int k = 0;
  for (int i = touch.jacobian.leaf; i >= 0; i = parents[static_cast<std::size_t>(i)], ++k) {
    for (int axis = 0; axis < 3; ++axis) change[axis] += touch.jacobian.row[axis][k] * du[i];
  }
  return change;
}

bool GroundContact::revise(const Eigen::VectorXd& du) {
  bool changed = false;
  for (std::size_t t = 0; t < touch_count_; ++t) {
    Touch& touch = touches_[t];
    if (touch.mode == Mode::Open) continue;
    const Vec3 change = velocityChange(touch, mass_->parents(), du);
    touch.force = touch.now - touch.change.cwiseProduct(change);
    changed |= reviseTouch(touch);
  }
  return changed;
}

bool GroundContact::reviseTouch(Touch& touch) {
  if (touch.force.z() < 0) {
    touch.mode = Mode::Open;
    touch.force.setZero();
    return true;
  }
  const double hold = material_.friction * touch.force.z();
  if (touch.mode != Mode::Stick || touch.force.head<2>().norm() <= hold) return false;
  slide(touch, touch.force.z());
  return true;
}

void GroundContact::finish(const Eigen::VectorXd& du) {
  forces_.clear();
  for (std::size_t t = 0; t < touch_count_; ++t) {
    const Touch& touch = touches_[t];
    Anchor& anchor = anchors_[touch.point];
    if (touch.mode == Mode::Open) {
      anchor.touching = false;
      continue;
    }
    if (touch.mode == Mode::Slide) {
      const Vec3 v_W = touch.v_W + velocityChange(touch, mass_->parents(), du);
      anchor.place = touch.p_W.head<2>() + h_ * v_W.head<2>() +
                     touch.force.head<2>() / material_.tangential_stiffness;
    }
    const Point& point = points_[touch.point];
    forces_.push_back({point.body, point.foot, point.p_B, touch.force, -touch.p_W.z()});
  }
}

}  // namespace nao::sim
