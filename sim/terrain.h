#pragma once

#include <vector>

#include "core/world_model.h"

namespace nao::sim {

/// What stands still: the ground's plane through W's origin, and obstacles.
class Terrain {
 public:
  static constexpr int kGround = -1;
  struct Spot {                // where a point stands over a surface
    int surface = kGround;     // else an obstacle's index
    double distance = 0;       // [m] negative: inside
    Vec3 n_W = Vec3::UnitZ();  // unit, outwards
  };

  Terrain(const Material& ground, const Vec3& ground_normal,
          const std::vector<Obstacle>& obstacles);

  const Material& material(int surface) const {
    return surface == kGround ? ground_ : obstacles_[static_cast<std::size_t>(surface)].material;
  }
  const Vec3& groundNormal() const { return normal_; }
  Spot overGround(const Vec3& p_W) const { return {kGround, normal_.dot(p_W), normal_}; }

  int obstacleCount() const { return static_cast<int>(obstacles_.size()); }
  /// Those of which any part may be in this sphere, by index.
  void findNear(const Vec3& center_W, double radius, std::vector<int>& near) const;
  Spot overObstacle(const Vec3& p_W, int obstacle) const;
  /// Above all obstacles [m].
  double top() const { return top_; }

 private:
  Material ground_;
  Vec3 normal_;
  std::vector<Obstacle> obstacles_;
  std::vector<double> radius_;  // [m] of a sphere about each obstacle
  double top_ = 0;
};

}  // namespace nao::sim
