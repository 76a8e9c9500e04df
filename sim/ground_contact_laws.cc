#include <algorithm>
#include <cmath>

#include "sim/ground_contact.h"

namespace nao::sim {
namespace {

constexpr double kSlowSliding = 0.02;  // [m/s] free choice: a Nao's feet stick or slide faster
constexpr double kSlowSpin = 0.05;     // [rad/s] free choice: slower spins are braked, not slid
constexpr double kBounce = 0.1;        // [m/s] free choice: slower approaches do not come back
// [N s/m] free choice: a hundred times what the heaviest robot's point needs, so that it ends the
// step with the speed asked for to 1 %, and far from spoiling the sums of 1e-16 beside it.
constexpr double kHard = 1e6;

}  // namespace

void GroundContact::begin(Touch& touch) const {
  touch.twist = touch.twist_change = 0;
  stick(touch);
  if (touch.material->restitution > 0 && touch.v.z() < -kBounce) bounce(touch);
}

void GroundContact::goOn(Touch& touch, const Anchor& anchor) const {
  touch.twist = touch.twist_change = 0;
  stick(touch);
  if (anchor.sliding && touch.v.head<2>().norm() > kSlowSliding) slide(touch, anchor.load);
  if (touch.spin != 0 && touch.material->torsional_friction > 0) twist(touch, anchor.load);
}

// Turns the tangents of a touch, so that the first is along (x, y) of the present frame.
void GroundContact::turnTo(Touch& touch, double x, double y) const {
  const Vec3 along = x * touch.R.col(0) + y * touch.R.col(1);
  touch.R.col(1) = touch.R.col(2).cross(along);
  touch.R.col(0) = along;
  const double v = x * touch.v.x() + y * touch.v.y();
  touch.v.y() = x * touch.v.y() - y * touch.v.x();
  touch.v.x() = v;
}

void GroundContact::stick(Touch& touch) const {
  const Material& m = *touch.material;
  touch.mode = Mode::Stick;
  Vec3 next = touch.R.transpose() * (touch.p_W - anchors_[touch.anchor].place);
  next.z() = -touch.depth;
  next += h_ * touch.v;
  const Vec3 k(m.tangential_stiffness, m.tangential_stiffness, m.stiffness);
  const Vec3 d(m.tangential_damping, m.tangential_damping, m.damping);
  touch.now = -k.cwiseProduct(next) - d.cwiseProduct(touch.v);
  touch.change = h_ * k + d;
}

// Ends the step with -e times the approach, whatever that takes.
void GroundContact::bounce(Touch& touch) const {
  touch.change.z() = kHard;
  touch.now.z() = -kHard * (1 + touch.material->restitution) * touch.v.z();
}

// mu f_n against the motion: constant along it, and turning with it as the motion turns. A point
// that hardly moves yields against the pull that it can not hold, so that others take over.
void GroundContact::slide(Touch& touch, double load) const {
  const double speed = touch.v.head<2>().norm();
  const double friction = touch.material->friction * load;
  if (speed < kSlowSliding) {
    touch.now.head<2>() = friction * touch.force.head<2>().normalized();
    touch.change.head<2>().setZero();
    touch.mode = Mode::Brake;
    return;
  }
  touch.mode = Mode::Slide;
  turnTo(touch, touch.v.x() / speed, touch.v.y() / speed);
  touch.now.head<2>() = Eigen::Vector2d(-friction, 0);
  touch.change.head<2>() = Eigen::Vector2d(0, friction / speed);
}

// The same force, falling to nothing as the point comes to rest: it never turns back.
void GroundContact::brake(Touch& touch) const {
  touch.mode = Mode::Brake;
  touch.change.x() = -touch.now.x() / touch.v.x();
}

// The largest torque there is against the spin; one that is slow is braked.
void GroundContact::twist(Touch& touch, double load) const {
  const double most = touch.material->torsional_friction * load;
  const double speed = std::max(std::abs(touch.spin), kSlowSpin);
  touch.twist = -most * touch.spin / speed;
  touch.twist_change = std::abs(touch.spin) < kSlowSpin ? most / speed : 0;
}

bool GroundContact::keepsTwist(Touch& touch, double spin_after) const {
  if (touch.twist == 0 || touch.twist_change > 0 || spin_after * touch.spin >= 0) return true;
  touch.twist_change = -touch.twist / touch.spin;
  return false;
}

bool GroundContact::keepsFriction(Touch& touch) const {
  const double load = std::max(0.0, touch.force.z());
  if (touch.mode == Mode::Stick) {
    if (touch.force.head<2>().norm() <= touch.material->friction * load) return true;
    slide(touch, load);
    return false;
  }
  if (touch.mode != Mode::Slide || touch.after.x() >= 0) return true;
  brake(touch);
  return false;
}

}  // namespace nao::sim
