#pragma once

#include <vector>

#include "core/world_model.h"
#include "sim/wet_patch.h"

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

  /// Of a surface at a point.
  const Material& material(int surface, const Vec3& p_W) const {
    if (surface != kGround) return obstacles_[static_cast<std::size_t>(surface)].material;
    return wet_.empty() ? ground_ : groundAt(p_W);
  }
  /// In place of those there were.
  void setWet(const std::vector<WetPatch>& patches);
  Spot overGround(const Vec3& p_W) const { return {kGround, normal_.dot(p_W), normal_}; }

  int obstacleCount() const { return static_cast<int>(obstacles_.size()); }
  /// Those of which any part may be in this sphere, by index.
  void findNear(const Vec3& center_W, double radius, std::vector<int>& near) const;
  Spot overObstacle(const Vec3& p_W, int obstacle) const;
  /// Above all obstacles [m].
  double top() const { return top_; }

 private:
  const Material& groundAt(const Vec3& p_W) const;

  Material ground_;
  struct Wet {
    WetPatch patch;
    Material material;
  };
  std::vector<Wet> wet_;
  Vec3 normal_;
  std::vector<Obstacle> obstacles_;
  std::vector<double> radius_;  // [m] of a sphere about each obstacle
  double top_ = 0;
};

}  // namespace nao::sim
