#include "core/shape_gap.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "core/shape_distance.h"
#include "tests/support/shape_gap.h"

namespace nao {
namespace {

Vec3 anyVector(Random& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Pose anyPose(Random& random) {
  Pose X = translation(anyVector(random, 0.25));
  X.linear() =
      Eigen::Quaterniond(random.normal(), random.normal(), random.normal(), random.normal())
          .normalized()
          .toRotationMatrix();
  return X;
}

Shape anyShape(Random& random, Shape::Kind kind) {
  Shape shape;
  shape.kind = kind;
  for (double& edge : shape.size) edge = random.uniform(0.02, 0.15);
  return shape;
}

constexpr Shape::Kind kKinds[] = {Shape::Kind::Sphere, Shape::Kind::Box, Shape::Kind::Cylinder,
                                  Shape::Kind::Capsule};

// Against a slow search by another way (Frank and Wolfe), to its tolerance of 0.1 mm; two solids of
// which neither is round and one a cylinder, to the 2 % of a radius that a prism of 16 sides lacks.
TEST(ShapeGap, IsTheDistanceOfSolidsThatAreApart) {
  Random random(4);
  int apart = 0;
  for (int trial = 0; trial < 1600; ++trial) {
    const Shape a = anyShape(random, kKinds[trial % 4]);
    const Shape b = anyShape(random, kKinds[trial / 4 % 4]);
    const Pose X_WA = anyPose(random);
    const Pose X_WB = anyPose(random);
    const double expected = test::shapeGap(a, X_WA, b, X_WB);
    if (expected < 1e-3) continue;
    ++apart;
    const auto flat = [](const Shape& shape) {
      return shape.kind == Shape::Kind::Box || shape.kind == Shape::Kind::Cylinder;
    };
    const bool prism =
        flat(a) && flat(b) && (a.kind == Shape::Kind::Cylinder || b.kind == Shape::Kind::Cylinder);
    const ShapeGap gap = calcShapeGap(a, X_WA, b, X_WB);
    ASSERT_NEAR(gap.distance, expected, prism ? 0.02 * 0.15 + 1e-4 : 2e-4)
        << static_cast<int>(a.kind) << " " << static_cast<int>(b.kind) << " " << trial;
    ASSERT_NEAR(gap.n_W.norm(), 1, 1e-12);
    // Moving one along the normal by so much closes the gap.
    const Pose closed = translation(-(gap.distance + 1e-3) * gap.n_W) * X_WA;
    if (!prism) {
      ASSERT_LT(calcShapeGap(a, closed, b, X_WB).distance, 0);
    }
  }
  EXPECT_GT(apart, 400);
}

TEST(ShapeGap, IsTheSameFromBothSides) {
  Random random(5);
  for (int trial = 0; trial < 400; ++trial) {
    const Shape a = anyShape(random, kKinds[trial % 4]);
    const Shape b = anyShape(random, kKinds[trial / 4 % 4]);
    const Pose X_WA = anyPose(random);
    const Pose X_WB = anyPose(random);
    const ShapeGap one = calcShapeGap(a, X_WA, b, X_WB);
    const ShapeGap other = calcShapeGap(b, X_WB, a, X_WA);
    ASSERT_NEAR(one.distance, other.distance, 1e-9);
  }
}

// A box by another name.
TEST(ShapeGap, AHullIsAsFarAsTheBoxOfItsCorners) {
  Random random(6);
  for (int trial = 0; trial < 400; ++trial) {
    const Shape box = anyShape(random, Shape::Kind::Box);
    Shape hull = box;
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
      const Vec3 side(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5);
      corners.push_back(side.cwiseProduct(box.size));
    }
    hull.kind = Shape::Kind::Hull;
    hull.hull = std::make_shared<const Hull>(calcHull(corners));
    const Shape other = anyShape(random, kKinds[trial % 4]);
    const Pose X_WA = anyPose(random);
    const Pose X_WB = anyPose(random);
    ASSERT_NEAR(calcShapeGap(hull, X_WA, other, X_WB).distance,
                calcShapeGap(box, X_WA, other, X_WB).distance, 1e-9);
  }
}

TEST(ShapeGap, OverlapIsHowFarTheyMustPart) {
  Shape sphere;
  sphere.size.x() = 0.1;
  Shape box;
  box.kind = Shape::Kind::Box;
  box.size = Vec3(1, 1, 1);
  const ShapeGap gap = calcShapeGap(sphere, translation(Vec3(0.1, 0, 0.57)), box, Pose::Identity());
  EXPECT_NEAR(gap.distance, -0.03, 1e-12);
  EXPECT_NEAR((gap.n_W - Vec3::UnitZ()).norm(), 0, 1e-12);
  EXPECT_NEAR(gap.p_W.z(), 0.485, 1e-12);
}

}  // namespace
}  // namespace nao
