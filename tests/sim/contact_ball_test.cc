// A ball: sliding, rolling, bouncing, against its laws.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kGravity = 9.80665;

std::shared_ptr<WorldModel> worldWithBall() {
  auto world = test::flatWorld();
  world->balls.assign(1, Ball());
  world->balls[0].rolling_deceleration = 0;
  return world;
}

Vec3 place(const World& world) { return world.scene().balls[0].p_W; }

void run(World& world, double seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / toSeconds(world.stepSize())));
  for (int k = 0; k < steps; ++k) world.step();
}

// Set down sliding, by a millimetre's fall, so that it has no spin yet: a solid sphere ends up
// rolling at 5/7 of its speed, a thin shell at 3/5, after mu g t = 2/7 v0 (2/5 v0).
TEST(BallContact, SlidingTurnsIntoRolling) {
  for (const double factor : {0.4, 2.0 / 3}) {
    auto model = worldWithBall();
    model->ground.friction = 0.3;
    model->balls[0].inertia_factor = factor;
    World world(model, {}, 2ms);
    const double radius = model->balls[0].radius;
    world.placeBall(0, Vec3(0, 0, radius + 1e-3), Vec3(1, 0, 0));
    const double lost = factor / (1 + factor);  // part of v0
    run(world, lost / (0.3 * kGravity) + 0.05);
    const double from = place(world).x();
    run(world, 0.5);
    EXPECT_NEAR((place(world).x() - from) / 0.5, 1 - lost, 1e-3) << factor;
  }
}

TEST(BallContact, RollsWithoutSlippingAndTurnsAsFarAsItGoes) {
  auto model = worldWithBall();
  World world(model, {}, 2ms);
  world.placeBall(0, Vec3::Zero(), Vec3(0.2, 0, 0));
  run(world, 0.5);
  const Eigen::AngleAxisd turn(world.scene().balls[0].R_W);
  EXPECT_NEAR(turn.angle(), 0.1 / model->balls[0].radius, 1e-6);
  EXPECT_NEAR(turn.axis().y(), 1, 1e-9);
}

// Rolls down a slope with a = g sin / (1 + 2/5).
TEST(BallContact, RollsDownASlope) {
  auto model = worldWithBall();
  model->ground_normal = Vec3(std::sin(0.1), 0, std::cos(0.1));
  World world(model, {}, 2ms);
  world.placeBall(0, Vec3(0, 0, 0), Vec3::Zero());
  run(world, 1);
  const double along = place(world).x() / std::cos(0.1);
  EXPECT_NEAR(along, 0.5 * kGravity * std::sin(0.1) / 1.4, 0.01 * along);  // first order in h
}

// On the ground, and back from a goal post: e times the speed it came with.
TEST(BallContact, BouncesToESquaredOfItsHeight) {
  auto model = worldWithBall();
  model->balls[0].material.restitution = 0.7;
  World world(model, {}, 1ms);
  const double radius = model->balls[0].radius;
  world.placeBall(0, Vec3(0, 0, radius + 1), Vec3::Zero());
  run(world, std::sqrt(2 / kGravity) + 0.01);
  double top = 0;
  for (int k = 0; k < 500; ++k) {
    world.step();
    top = std::max(top, place(world).z() - radius);
  }
  EXPECT_NEAR(top, 0.49, 0.01);  // one step's way is 4 mm
}

TEST(BallContact, ComesBackFromAGoalPost) {
  auto model = worldWithBall();
  Obstacle post;
  post.shape.kind = Shape::Kind::Cylinder;
  post.shape.size = Vec3(0.05, 0, 1);
  post.shape.X_BS = translation(Vec3(1, 0, 0.5));
  post.material.restitution = 0.5;
  post.material.friction = 0;
  model->obstacles = {post};
  model->ground.friction = 0;
  World world(model, {}, 2ms);
  world.placeBall(0, Vec3(0.5, 0, 0), Vec3(2, 0, 0));
  run(world, 0.4);
  const double before = place(world).x();
  EXPECT_LT(before, 0.95);
  run(world, 0.1);
  EXPECT_NEAR((place(world).x() - before) / 0.1, -0.5 * 2, 0.02);
}

TEST(BallContact, GoesOnFromASnapshotWithItsSpin) {
  World world(worldWithBall(), {}, 2ms);
  world.placeBall(0, Vec3(0, 0, 0.1), Vec3(1, 0.3, 0));
  run(world, 0.2);
  const auto snapshot = world.snapshot();
  run(world, 0.3);
  World other(worldWithBall(), {}, 2ms);
  other.restore(*snapshot);
  run(other, 0.3);
  EXPECT_EQ(world.hash(), other.hash());
}

}  // namespace
}  // namespace nao::sim
