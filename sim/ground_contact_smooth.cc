#include <algorithm>

#include "sim/ground_contact.h"

namespace nao::sim {

// The springs and dampers of the implicit law at this very state, kept within pull and friction.
GroundContact::Smooth GroundContact::calcSmooth(std::size_t i,
                                                const std::vector<BodyMotion>& motion) const {
  const Point& point = points_[i];
  const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
  Vec3 arm = body.R_WB * point.p_B;
  arm.z() -= point.radius;
  Smooth out{body.p_WB + arm, Vec3::Zero(), false, false};
  if (out.p_W.z() >= 0) return out;
  out.touching = true;
  const Vec3 v_W = body.v_WB + body.w_WB.cross(arm);
  const Material& m = material_;
  out.f_W.z() = std::max(0.0, -m.stiffness * out.p_W.z() - m.damping * v_W.z());
  const Anchor& anchor = anchors_[i];
  const Eigen::Vector2d stretch =
      anchor.touching ? Eigen::Vector2d(out.p_W.head<2>() - anchor.place) : Eigen::Vector2d(0, 0);
  Eigen::Vector2d pull = -m.tangential_stiffness * stretch - m.tangential_damping * v_W.head<2>();
  const double most = m.friction * out.f_W.z();
  out.sliding = pull.norm() > most;
  if (out.sliding) pull *= most / pull.norm();
  out.f_W.head<2>() = pull;
  return out;
}

void GroundContact::addSmooth(const std::vector<BodyMotion>& motion,
                              std::vector<ExternalForce>& forces) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Smooth touch = calcSmooth(i, motion);
    if (touch.touching) forces.push_back({points_[i].body, touch.p_W, touch.f_W});
  }
}

void GroundContact::settle(const std::vector<BodyMotion>& motion) {
  forces_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Smooth touch = calcSmooth(i, motion);
    Anchor& anchor = anchors_[i];
    if (touch.touching && !anchor.touching) anchor.place = touch.p_W.head<2>();
    if (touch.sliding) {
      anchor.place = touch.p_W.head<2>() + touch.f_W.head<2>() / material_.tangential_stiffness;
    }
    anchor.touching = touch.touching;
    anchor.sliding = touch.sliding;
    anchor.load = touch.f_W.z();
    if (!touch.touching) continue;
    forces_.push_back(
        {points_[i].body, points_[i].foot, points_[i].p_B, touch.f_W, -touch.p_W.z()});
  }
}

}  // namespace nao::sim
