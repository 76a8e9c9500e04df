#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/shape_distance.h"
#include "sim/sonar.h"

namespace nao::sim {
namespace {

constexpr double kHalfCone = M_PI / 6;
constexpr double kFarthest = 2.5;  // [m]

// The cone's apex is the origin, its axis x.
double hit(const Vec3& way, const Shape& shape, const Pose& X_SW) {
  double along = 0;
  for (int k = 0; k < 200 && along < kFarthest; ++k) {
    const double free = calcSurfacePoint(shape, X_SW * Vec3(along * way)).distance;
    if (free < 1e-4) return along;
    along += free;
  }
  return kFarthest;
}

// By very many rays: never nearer than the truth.
double searchByRays(const Shape& shape, const Pose& X_WS) {
  const Pose X_SW = X_WS.inverse();
  double found = hit(Vec3::UnitX(), shape, X_SW);
  for (int ring = 1; ring <= 24; ++ring) {
    const double angle = kHalfCone * ring / 24;
    for (int k = 0; k < 96; ++k) {
      const double turn = 2 * M_PI * k / 96;
      const Vec3 way(std::cos(angle), std::sin(angle) * std::cos(turn),
                     std::sin(angle) * std::sin(turn));
      found = std::min(found, hit(way, shape, X_SW));
    }
  }
  return found;
}

Shape anyShape(Random& random) {
  Shape shape;
  shape.kind = static_cast<Shape::Kind>(static_cast<int>(random.uniform(0, 4)));
  shape.size = Vec3(random.uniform(0.02, 0.2), random.uniform(0.02, 0.2), random.uniform(0.1, 1.5));
  return shape;
}

Pose anyPose(Random& random) {
  Pose pose = translation({random.uniform(0, 2), random.uniform(-1.2, 1.2), random.uniform(-1, 1)});
  const Eigen::Vector4d q(random.normal(), random.normal(), random.normal(), random.normal());
  pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  return pose;
}

TEST(SonarCone, FindsWhatThousandsOfRaysFind) {
  Random random(7);
  int heard = 0;
  int on_the_rim = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape shape = anyShape(random);
    const Pose X_WS = anyPose(random);
    const double rays = searchByRays(shape, X_WS);
    const auto found = calcDistanceInCone(Pose::Identity(), kHalfCone, kFarthest, shape, X_WS);
    if (rays >= kFarthest) continue;
    ++heard;
    EXPECT_TRUE(found.has_value()) << i << ", rays " << rays;
    if (!found) continue;
    EXPECT_LE(*found, rays + 2e-3) << i;  // a ray ends within 0.5 mm, seen at an angle
    EXPECT_GE(*found, rays - 0.05) << i;  // rays lie up to 5 cm apart
    const SurfacePoint nearest = calcSurfacePoint(shape, X_WS.inverse() * Vec3(0, 0, 0));
    on_the_rim += *found > nearest.distance + 1e-3;
  }
  EXPECT_GT(heard, 100);
  EXPECT_GT(on_the_rim, 20);  // the harder kind is among them
}

}  // namespace
}  // namespace nao::sim
