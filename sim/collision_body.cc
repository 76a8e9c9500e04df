#include "sim/collision_body.h"

#include <algorithm>
#include <cmath>

#include "core/shape_distance.h"

namespace nao::sim {

CollisionBody::CollisionBody(const RobotModel& model) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    for (const Shape& shape : model.bodies[i].collisions) {
      solids_.push_back({static_cast<int>(i), shape});
      p_BS_.push_back(shape.X_BS.translation());
      bounds_.push_back({Vec3::Zero(), boundingRadius(shape)});
    }
  }
  findPairs(model);
}

void CollisionBody::findPairs(const RobotModel& model) {
  for (std::size_t a = 0; a < solids_.size(); ++a) {
    for (std::size_t b = a + 1; b < solids_.size(); ++b) {
      const std::pair<int, int> bodies = std::minmax(solids_[a].body, solids_[b].body);
      const auto& never = model.no_collision;
      if (bodies.first == bodies.second) continue;
      if (std::find(never.begin(), never.end(), bodies) != never.end()) continue;
      const double reach = bounds_[a].radius + bounds_[b].radius;
      pairs_.push_back({static_cast<int>(a), static_cast<int>(b), reach * reach});
    }
  }
}

void CollisionBody::update(const std::vector<BodyMotion>& motion) {
  double reach_squared = 0;
  double largest = 0;
  whole_.p_W = motion[0].p_WB;
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const BodyMotion& body = motion[static_cast<std::size_t>(solids_[i].body)];
    bounds_[i].p_W = body.p_WB + body.R_WB * p_BS_[i];
    reach_squared = std::max(reach_squared, (bounds_[i].p_W - whole_.p_W).squaredNorm());
    largest = std::max(largest, bounds_[i].radius);
  }
  whole_.radius = std::sqrt(reach_squared) + largest;
}

Pose CollisionBody::calcPose(std::size_t i, const std::vector<BodyMotion>& motion) const {
  const BodyMotion& body = motion[static_cast<std::size_t>(solids_[i].body)];
  Pose X_WB = Pose::Identity();
  X_WB.linear() = body.R_WB;
  X_WB.translation() = body.p_WB;
  return X_WB * solids_[i].shape.X_BS;
}

}  // namespace nao::sim
