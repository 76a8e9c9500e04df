#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

constexpr double kMass = 2, kGravity = 10, kStep = 0.001;

std::shared_ptr<RobotModel> brick() { return nao::test::block(kMass, Vec3(0.2, 0.2, 0.05)); }

// Once it lies still.
Rig restingBrick(const std::vector<EffectSetting>& effects) {
  Rig rig(brick(), effects, kGravity, kStep);
  rig.run(1);
  return rig;
}

constexpr int kVx = 3, kWz = 2;  // in the speeds of a free root

TEST(LinearDamping, SlowsAThrowExponentially) {
  Rig rig(brick(), {effect("linear_damping", {{"rate", 0.8}})}, 0, kStep);
  TreeState tree = rig.body().tree();
  tree.q[6] = 10;
  rig.body().setTree(tree);
  rig.setSpeed(kVx, 3);
  rig.run(1);
  // Explicit Euler's decay is exp(-c t) (1 - c^2 h t / 2) to first order.
  EXPECT_NEAR(rig.body().tree().u[kVx], 3 * std::exp(-0.8), 3 * 0.64 * kStep / 2);
}

TEST(AngularDamping, SlowsASpinExponentially) {
  Rig rig(brick(), {effect("angular_damping", {{"rate", 0.8}})}, 0, kStep);
  TreeState tree = rig.body().tree();
  tree.q[6] = 10;
  rig.body().setTree(tree);
  rig.setSpeed(kWz, 3);
  rig.run(1);
  EXPECT_NEAR(rig.body().tree().u[kWz], 3 * std::exp(-0.8), 3 * 0.64 * kStep / 2);
}

TEST(GroundFriction, SlowsASlidingBrickByItsScale) {
  const double mu = nao::test::flatWorld()->ground.friction;
  for (const double scale : {1.0, 0.5}) {
    Rig rig = restingBrick({effect("ground_friction", {{"scale", scale}})});
    TreeState tree = rig.body().tree();
    tree.u[kVx] = 2;
    rig.body().setTree(tree);
    rig.run(0.1);
    const double before = rig.body().tree().u[kVx];
    rig.run(0.1);
    const double slowing = (before - rig.body().tree().u[kVx]) / 0.1;
    EXPECT_NEAR(slowing, scale * mu * kGravity, 0.01 * slowing) << scale;
  }
}

TEST(GroundCompliance, SinksBySoftness) {
  const auto depth = [](double softness) {
    Rig rig = restingBrick({effect("ground_compliance", {{"softness", softness}})});
    return -rig.body().lowestPoint();
  };
  const double nominal = kMass * kGravity / 4 / nao::test::flatWorld()->ground.stiffness;
  EXPECT_NEAR(depth(1), nominal, 1e-3 * nominal);
  EXPECT_NEAR(depth(5), 5 * nominal, 5e-3 * nominal);
}

TEST(GroundTilt, TurnsTheNormalAboutXThenY) {
  Rig rig(brick(), {effect("ground_tilt", {{"x", 0.1}, {"y", 0.2}})}, kGravity, kStep);
  const Vec3 expected = Eigen::AngleAxisd(0.2, Vec3::UnitY()) *
                        (Eigen::AngleAxisd(0.1, Vec3::UnitX()) * Vec3::UnitZ());
  EXPECT_LT((rig.plan().ground_normal - expected).norm(), 1e-15);
}

TEST(GroundTilt, TurnsAFixedBaseAlong) {
  Rig rig(freeRod(0.5, 0.2), {effect("ground_tilt", {{"x", 0}, {"y", 0.2}})}, kGravity, kStep);
  const double acceleration = kGravity * std::cos(0.2) / 0.2;  // of a rod tilted by 0.2 rad
  rig.run(kStep);
  EXPECT_NEAR(rig.rate() / kStep, acceleration, 1e-2 * acceleration);
}

}  // namespace
}  // namespace nao::sim::test
