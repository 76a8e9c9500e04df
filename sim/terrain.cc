#include "sim/terrain.h"

#include <algorithm>

#include "core/shape_distance.h"

namespace nao::sim {

Terrain::Terrain(const Material& ground, const Vec3& ground_normal,
                 const std::vector<Obstacle>& obstacles)
    : ground_(ground), normal_(ground_normal), obstacles_(obstacles) {
  for (const Obstacle& obstacle : obstacles_) {
    radius_.push_back(boundingRadius(obstacle.shape));
    top_ = std::max(top_, obstacle.shape.X_BS.translation().z() + radius_.back());
  }
}

void Terrain::setWet(const std::vector<WetPatch>& patches) {
  wet_.clear();
  for (const WetPatch& patch : patches) {
    wet_.push_back({patch, ground_});
    wet_.back().material.friction = std::min(ground_.friction, patch.friction);
  }
}

const Material& Terrain::groundAt(const Vec3& p_W) const {
  for (const auto& [patch, material] : wet_) {
    const double x = p_W.x() - patch.x;
    const double y = p_W.y() - patch.y;
    if (x * x + y * y <= patch.radius * patch.radius) return material;
  }
  return ground_;
}

void Terrain::findNear(const Vec3& center_W, double radius, std::vector<int>& near) const {
  near.clear();
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const double reach = radius + radius_[i];
    const Vec3 away = obstacles_[i].shape.X_BS.translation() - center_W;
    if (away.squaredNorm() < reach * reach) near.push_back(static_cast<int>(i));
  }
}

Terrain::Spot Terrain::overObstacle(const Vec3& p_W, int obstacle) const {
  const Shape& shape = obstacles_[static_cast<std::size_t>(obstacle)].shape;
  const Pose& X_WS = shape.X_BS;
  const SurfacePoint surface =
      calcSurfacePoint(shape, X_WS.linear().transpose() * (p_W - X_WS.translation()));
  return {obstacle, surface.distance, X_WS.linear() * surface.normal};
}

}  // namespace nao::sim
