#include "sim/ground_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace nao::sim {
namespace {

constexpr double kFastest = 30;  // [m/s] of any point of a robot: a Nao's limbs reach 3

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

// How far [m] a point of a body may be from the root's origin.
double reachOf(const RobotModel& model, int body, const Vec3& p_B) {
  double reach = p_B.norm();
  for (int b = body; b > 0; b = model.bodies[static_cast<std::size_t>(b)].parent) {
    reach += model.bodies[static_cast<std::size_t>(b)].X_PB.translation().norm();
  }
  return reach;
}

// Axes along and across a surface, along those of W on level ground.
Mat3 frameOn(const Vec3& n_W) {
  Mat3 R;
  const Vec3 side = std::abs(n_W.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
  R.col(0) = (side - n_W.dot(side) * n_W).normalized();
  R.col(1) = n_W.cross(R.col(0));
  R.col(2) = n_W;
  return R;
}

}  // namespace

GroundContact::GroundContact(const BodyPlan& plan)
    : terrain_(plan.ground, plan.ground_normal, plan.obstacles) {
  const RobotModel& model = plan.model;
  for (std::size_t i = 0; i < model.feet.size(); ++i) addFoot(model.feet[i], static_cast<int>(i));
  for (const ContactSphere& sphere : model.contact_spheres) {
    points_.push_back({sphere.body, -1, sphere.p_B, sphere.radius});
  }
  for (const Point& point : points_) {
    reach_ = std::max(reach_, reachOf(model, point.body, point.p_B) + point.radius);
  }
  anchors_.resize(2 * points_.size());
  touches_.resize(2 * points_.size());
  groups_.resize(model.bodies.size());
  forces_.reserve(2 * points_.size());
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
    archive.value(anchor.surface);
    archive.value(anchor.load);
    archive.value(anchor.approach);
    archive.numbers(anchor.place);
  }
  archive.each(forces_, [&archive](Force& force) {
    archive.value(force.body);
    archive.value(force.foot);
    archive.numbers(force.p_B);
    archive.numbers(force.f_W);
    archive.value(force.depth);
  });
}

Vec3 GroundContact::centerOf(const Point& point, const std::vector<BodyMotion>& motion) const {
  const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
  return body.p_WB + body.R_WB * point.p_B;
}

double GroundContact::lowestPoint(const std::vector<BodyMotion>& motion) const {
  double lowest = std::numeric_limits<double>::max();
  for (const Point& point : points_) {
    lowest = std::min(lowest, terrain_.overGround(centerOf(point, motion)).distance - point.radius);
  }
  return points_.empty() ? 0 : lowest;
}

// From above all obstacles down in steps that can not pass through any, until one is touched.
double GroundContact::calcLift(const std::vector<BodyMotion>& motion) const {
  constexpr double kClose = 1e-6;  // [m]
  const auto gapAt = [&](double lift) {
    double gap = std::numeric_limits<double>::max();
    for (const Point& point : points_) {
      const Vec3 p_W = centerOf(point, motion) + Vec3(0, 0, lift);
      for (int i = 0; i < terrain_.obstacleCount(); ++i) {
        gap = std::min(gap, terrain_.overObstacle(p_W, i).distance - point.radius);
      }
    }
    return gap;
  };
  constexpr double kAbove = 1e-3;  // [m] for obstacles that stand on the ground as the robot does
  if (terrain_.obstacleCount() == 0 || gapAt(kAbove) > -kClose) return 0;
  double lift = terrain_.top() + 2 * reach_;
  for (int i = 0; i < 1000 && lift > 0; ++i) {
    const double gap = gapAt(lift);
    if (gap < kClose) break;
    lift -= gap;
  }
  return std::max(0.0, lift);
}

bool GroundContact::findObstacle(const Vec3& p_W, Terrain::Spot& spot) const {
  bool found = false;
  for (const int i : near_) {
    const Terrain::Spot other = terrain_.overObstacle(p_W, i);
    if (found && other.distance >= spot.distance) continue;
    spot = other;
    found = true;
  }
  return found;
}

void GroundContact::prepare(const std::vector<BodyMotion>& motion, const TreeDynamics& mass,
                            double h) {
  h_ = h;
  mass_ = &mass;
  touch_count_ = group_count_ = 0;
  if (terrain_.obstacleCount() > 0) terrain_.findNear(motion[0].p_WB, reach_, near_);
  const double height = terrain_.overGround(motion[0].p_WB).distance;
  if (near_.empty() && height > reach_ + kFastest * h) {  // it hangs
    for (Anchor& anchor : anchors_) anchor.touching = false;
    return;
  }
  Terrain::Spot spot;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const BodyMotion& body = motion[static_cast<std::size_t>(points_[i].body)];
    const Vec3 center_W = body.p_WB + body.R_WB * points_[i].p_B;
    meet(2 * i, terrain_.overGround(center_W), center_W, body);
    if (near_.empty() || !findObstacle(center_W, spot)) {
      anchors_[2 * i + 1].touching = false;
    } else {
      meet(2 * i + 1, spot, center_W, body);
    }
  }
}

void GroundContact::meet(std::size_t anchor, const Terrain::Spot& spot, const Vec3& center_W,
                         const BodyMotion& body) {
  const Point& point = points_[anchor / 2];
  const double gap = spot.distance - point.radius;
  const Vec3 p_W = center_W - point.radius * spot.n_W;
  const Vec3 v_W = body.v_WB + body.w_WB.cross(p_W - body.p_WB);
  if (std::min(gap, gap + h_ * spot.n_W.dot(v_W)) >= 0) {
    anchors_[anchor].touching = false;
    return;
  }
  open(anchor, spot, p_W, v_W, point.radius > 0 ? spot.n_W.dot(body.w_WB) : 0);
}

void GroundContact::open(std::size_t index, const Terrain::Spot& spot, const Vec3& p_W,
                         const Vec3& v_W, double spin) {
  Touch& touch = touches_[touch_count_++];
  const Point& point = points_[index / 2];
  touch.anchor = index;
  touch.group = groupOf(point.body);
  touch.material = &terrain_.material(spot.surface, p_W);
  touch.p_W = p_W;
  touch.r = p_W - mass_->rootOrigin();
  touch.depth = point.radius - spot.distance;
  touch.R = frameOn(spot.n_W);
  touch.v = touch.R.transpose() * v_W;
  touch.spin = spin;
  Anchor& anchor = anchors_[index];
  if (!anchor.touching || anchor.surface != spot.surface) {
    anchor = {true, false, spot.surface, 0, -touch.v.z(), p_W};
    begin(touch);
  } else {
    goOn(touch, anchor);
  }
}

std::size_t GroundContact::groupOf(int body) {
  for (std::size_t g = group_count_; g-- > 0;) {
    if (groups_[g].body == body) return g;
  }
  groups_[group_count_].body = body;
  return group_count_++;
}

// Of a touch: rows g = (r x d, d) along the axes d of its frame, weighted and summed.
void GroundContact::add(const Touch& touch, Group& group) const {
  Eigen::Matrix<double, 6, 3> g;
  for (int axis = 0; axis < 3; ++axis) {
    g.col(axis).head<3>() = touch.r.cross(touch.R.col(axis));
    g.col(axis).tail<3>() = touch.R.col(axis);
  }
  group.wrench.noalias() += g * (h_ * touch.now);
  const Eigen::Matrix<double, 6, 3> weighted = g * (h_ * touch.change).asDiagonal();
  group.stiffness.noalias() += weighted * g.transpose();
  if (touch.twist_change == 0 && touch.twist == 0) return;
  const Vec3 n_W = touch.R.col(2);
  group.wrench.head<3>() += h_ * touch.twist * n_W;
  group.stiffness.topLeftCorner<3, 3>() += h_ * touch.twist_change * n_W * n_W.transpose();
}

void GroundContact::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) {
  for (std::size_t g = 0; g < group_count_; ++g) {
    groups_[g].stiffness.setZero();
    groups_[g].wrench.setZero();
  }
  for (std::size_t t = 0; t < touch_count_; ++t) {
    if (touches_[t].mode != Mode::Open) add(touches_[t], groups_[touches_[t].group]);
  }
  for (std::size_t g = 0; g < group_count_; ++g) {
    mass_->addBodyStiffness(groups_[g].body, groups_[g].stiffness, matrix);
    mass_->addBodyWrench(groups_[g].body, groups_[g].wrench, rhs);
  }
}

bool GroundContact::revise(const Eigen::VectorXd& du, bool may_open) {
  for (std::size_t g = 0; g < group_count_; ++g) {
    groups_[g].change = mass_->calcBodyVelocity(du, groups_[g].body);
  }
  bool changed = false;
  for (std::size_t t = 0; t < touch_count_; ++t) {
    Touch& touch = touches_[t];
    const Spatial& body = groups_[touch.group].change;
    const Vec3 w = body.head<3>();
    const Vec3 change = touch.R.transpose() * (body.tail<3>() + w.cross(touch.r));
    touch.after = touch.v + change;
    if (touch.mode == Mode::Open) continue;
    touch.force = touch.now - touch.change.cwiseProduct(change);
    changed |= !keepsFriction(touch);
    changed |= !keepsTwist(touch, touch.spin + touch.R.col(2).dot(w));
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

void GroundContact::finish(const std::vector<BodyMotion>& motion) {
  forces_.clear();
  for (std::size_t t = 0; t < touch_count_; ++t) {
    const Touch& touch = touches_[t];
    Anchor& anchor = anchors_[touch.anchor];
    anchor.touching = touch.mode != Mode::Open;
    if (!anchor.touching) continue;
    const Vec3 f_W = touch.R * touch.force;
    const Vec3 pull_W = f_W - touch.force.z() * touch.R.col(2);
    anchor.load = std::max(0.0, touch.force.z());
    anchor.sliding = touch.mode != Mode::Stick;
    if (anchor.sliding) {
      anchor.place =
          touch.p_W + h_ * (touch.R * touch.after) + pull_W / touch.material->tangential_stiffness;
    }
    const Point& point = points_[touch.anchor / 2];
    const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
    const Vec3 p_B =
        point.radius > 0 ? Vec3(body.R_WB.transpose() * (touch.p_W - body.p_WB)) : point.p_B;
    forces_.push_back({point.body, point.foot, p_B, f_W, touch.depth});
  }
}

}  // namespace nao::sim
