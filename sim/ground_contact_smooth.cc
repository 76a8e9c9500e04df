#include <algorithm>

#include "sim/ground_contact.h"

namespace nao::sim {
namespace {

constexpr double kSlowest = 0.01;  // [m/s] free choice: no approach was slower than this

// k z (1 + c z' / approach), c = 8 (1 - e) / (5 e): Flores, Machado, Silva and Martins, On the
// continuous contact force models for soft materials in multibody dynamics (2011).
double damping(const Material& material, double depth, double approach) {
  const double e = material.restitution;
  if (e <= 0) return material.damping;
  return material.stiffness * depth * 8 * (1 - e) / (5 * e) / std::max(approach, kSlowest);
}

}  // namespace

// The springs and dampers of the implicit law at this very state, kept within pull and friction.
GroundContact::Smooth GroundContact::calcSmooth(std::size_t index, const Terrain::Spot& spot,
                                                const std::vector<BodyMotion>& motion) const {
  const Point& point = points_[index / 2];
  const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
  Smooth out{};
  out.depth = point.radius - spot.distance;
  if (out.depth <= 0) return out;
  out.touching = true;
  out.p_W = body.p_WB + body.R_WB * point.p_B - point.radius * spot.n_W;
  const Vec3 v_W = body.v_WB + body.w_WB.cross(out.p_W - body.p_WB);
  const double leaving = spot.n_W.dot(v_W);
  const Material& m = terrain_.material(spot.surface, out.p_W);
  const Anchor& anchor = anchors_[index];
  const bool held = anchor.touching && anchor.surface == spot.surface;
  out.approach = held ? anchor.approach : -leaving;
  const double load =
      std::max(0.0, m.stiffness * out.depth - damping(m, out.depth, out.approach) * leaving);
  const Vec3 stretch = held ? Vec3(out.p_W - anchor.place) : Vec3(Vec3::Zero());
  Vec3 pull = -m.tangential_stiffness * stretch - m.tangential_damping * v_W;
  pull -= spot.n_W.dot(pull) * spot.n_W;
  const double most = m.friction * load;
  out.sliding = pull.norm() > most;
  if (out.sliding) pull *= most / pull.norm();
  out.f_W = pull + load * spot.n_W;
  return out;
}

template <class Visit>
void GroundContact::visitSmooth(const std::vector<BodyMotion>& motion, const Visit& visit) const {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3 center_W = centerOf(points_[i], motion);
    Terrain::Spot spot = terrain_.overGround(center_W);
    visit(2 * i, spot, calcSmooth(2 * i, spot, motion));
    if (terrain_.obstacleCount() == 0) continue;
    Terrain::Spot deepest = terrain_.overObstacle(center_W, 0);
    for (int k = 1; k < terrain_.obstacleCount(); ++k) {
      spot = terrain_.overObstacle(center_W, k);
      if (spot.distance < deepest.distance) deepest = spot;
    }
    visit(2 * i + 1, deepest, calcSmooth(2 * i + 1, deepest, motion));
  }
}

void GroundContact::addSmooth(const std::vector<BodyMotion>& motion,
                              std::vector<ExternalForce>& forces) const {
  visitSmooth(motion, [&](std::size_t i, const Terrain::Spot&, const Smooth& touch) {
    if (touch.touching) forces.push_back({points_[i / 2].body, touch.p_W, touch.f_W});
  });
}

void GroundContact::settle(const std::vector<BodyMotion>& motion) {
  forces_.clear();
  visitSmooth(motion, [&](std::size_t i, const Terrain::Spot& spot, const Smooth& touch) {
    Anchor& anchor = anchors_[i];
    const bool held = anchor.touching && anchor.surface == spot.surface;
    if (touch.touching && !held) anchor.place = touch.p_W;
    const Material& material = terrain_.material(spot.surface, touch.p_W);
    const double load = touch.touching ? spot.n_W.dot(touch.f_W) : 0;
    if (touch.sliding) {
      anchor.place = touch.p_W + (touch.f_W - load * spot.n_W) / material.tangential_stiffness;
    }
    anchor.touching = touch.touching;
    anchor.sliding = touch.sliding;
    anchor.surface = spot.surface;
    anchor.approach = touch.approach;
    anchor.load = load;
    if (!touch.touching) return;
    const Point& point = points_[i / 2];
    const BodyMotion& body = motion[static_cast<std::size_t>(point.body)];
    const Vec3 p_B = body.R_WB.transpose() * (touch.p_W - body.p_WB);
    forces_.push_back({point.body, point.foot, p_B, touch.f_W, touch.depth});
  });
}

}  // namespace nao::sim
