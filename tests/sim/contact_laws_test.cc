// What ground, slopes and obstacles do to bodies, each against its law.
#include <gtest/gtest.h>

#include <cmath>

#include "sim/robot_body.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kStep = 2e-3;
constexpr double kGravity = 9.80665;

std::shared_ptr<WorldModel> emptyWorld() {
  auto world = test::flatWorld();
  world->balls.clear();
  return world;
}

Vec3 tilted(double slope) { return {-std::sin(slope), 0, std::cos(slope)}; }

// A box of 1 m that is inclined about y: its top goes through the origin, downhill along -x.
Obstacle ramp(double slope) {
  Obstacle obstacle;
  obstacle.shape.kind = Shape::Kind::Box;
  obstacle.shape.size = Vec3(4, 2, 0.5);
  obstacle.shape.X_BS.linear() = Eigen::AngleAxisd(-slope, Vec3::UnitY()).toRotationMatrix();
  obstacle.shape.X_BS.translation() = 0.75 * Vec3::UnitZ() - 0.25 * tilted(slope);
  return obstacle;
}

JointCommand nothing() { return {JointArray<double>(0), JointArray<double>(0)}; }

void run(RobotBody& body, double seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / kStep));
  for (int k = 0; k < steps; ++k) body.step(nothing(), nullptr, {}, kStep);
}

// A block of 1 kg on a plane of this slope (or on a ramp of it), lying flat.
RobotBody blockOn(double slope, double friction, bool on_ramp) {
  auto world = emptyWorld();
  world->ground.friction = friction;
  if (on_ramp) {
    world->obstacles = {ramp(slope)};
    world->obstacles[0].material.friction = friction;
  } else {
    world->ground_normal = tilted(slope);
  }
  RobotBody body({*test::block(1, Vec3(0.2, 0.2, 0.05)), *world});
  TreeState state = body.tree();
  const Eigen::Quaterniond q(Eigen::AngleAxisd(-slope, Vec3::UnitY()));
  state.q.head<4>() << q.w(), q.x(), q.y(), q.z();
  state.q.segment<3>(4) =
      0.025 * tilted(slope) + (on_ramp ? Vec3(0.75 * Vec3::UnitZ()) : Vec3(Vec3::Zero()));
  body.setTree(state);
  return body;
}

class OnASlope : public testing::TestWithParam<bool> {};

TEST_P(OnASlope, ABlockSticksBelowTheAngleOfFriction) {
  RobotBody body = blockOn(std::atan(0.5) - 0.02, 0.5, GetParam());
  run(body, 1);
  const Vec3 before = body.motion()[0].p_WB;
  run(body, 10);
  EXPECT_LT((body.motion()[0].p_WB - before).norm(), 1e-5);  // [m] it sticks, it does not creep
}

// a = g (sin - mu cos). In the first step friction lags its load, and the springs settle: 0.5 % of
// half a second.
TEST_P(OnASlope, ABlockSlidesAboveItAsCoulombSays) {
  const double slope = 0.5;
  const double mu = 0.3;
  RobotBody body = blockOn(slope, mu, GetParam());
  run(body, 0.1);
  const Vec3 before = body.motion()[0].v_WB;
  run(body, 0.5);
  const double a = (body.motion()[0].v_WB - before).norm() / 0.5;
  EXPECT_NEAR(a, kGravity * (std::sin(slope) - mu * std::cos(slope)), 5e-3 * a);
}

INSTANTIATE_TEST_SUITE_P(PlaneAndRamp, OnASlope, testing::Bool());

// Up to e v after the fall; position is known to one step's way, h v.
TEST(Restitution, ABlockComesBackToESquaredOfItsHeight) {
  for (const double e : {0.3, 0.6}) {
    auto world = emptyWorld();
    world->ground.restitution = e;
    RobotBody body({*test::block(1, Vec3(0.2, 0.2, 0.1)), *world});
    TreeState state = body.tree();
    const double drop = 0.5;
    const double rest = state.q[6];
    state.q[6] += drop;
    body.setTree(state);
    const double fall = std::sqrt(2 * drop / kGravity);
    run(body, fall + 2 * kStep);
    double top = 0;
    for (int k = 0; k < 400; ++k) {
      run(body, kStep);
      if (k * kStep < 2 * e * fall) top = std::max(top, body.tree().q[6] - rest);
    }
    EXPECT_NEAR(top, e * e * drop, kStep * kGravity * fall) << e;
    EXPECT_NEAR(body.tree().q[6], rest, 0.12 * drop) << e;  // each bounce lower
  }
}

// The modes without an implicit step bounce by a spring and damper with the same e, to the few per
// cent that Flores et al. state for it.
TEST(Restitution, TheSmoothModesBounceAlike) {
  const double e = 0.6;
  auto world = emptyWorld();
  world->ground.restitution = e;
  RobotBody body({*test::block(1, Vec3(0.2, 0.2, 0.1)), *world}, Mode::Rk4);
  TreeState state = body.tree();
  state.q[6] += 0.2;
  body.setTree(state);
  double fastest_down = 0;
  double fastest_up = 0;
  for (int k = 0; k < 2000; ++k) {
    body.step(nothing(), nullptr, {}, 2e-4);
    fastest_down = std::min(fastest_down, body.tree().u[5]);
    if (fastest_down < -1) fastest_up = std::max(fastest_up, body.tree().u[5]);
  }
  EXPECT_NEAR(fastest_up / -fastest_down, e, 0.08);
}

// A sphere spinning about the vertical: w' = -mu_t m g / I until it stops.
TEST(TorsionalFriction, StopsASpinAfterThePredictedTime) {
  auto model = test::block(1, Vec3(0.1, 0.1, 0.1));
  model->feet.clear();
  model->contact_spheres = {{0, Vec3::Zero(), 0.05}};
  auto world = emptyWorld();
  world->ground.torsional_friction = 0.002;
  RobotBody body({*model, *world});
  TreeState state = body.tree();
  const double spin = 6;
  state.u[2] = spin;
  body.setTree(state);
  const double inertia = model->bodies[0].I_Bcm(2, 2);
  const double time = spin * inertia / (0.002 * 1 * kGravity);
  run(body, time / 2);
  EXPECT_NEAR(body.tree().u[2], spin / 2, 0.02 * spin);  // settling of the load at first
  run(body, time / 2 + 0.05);
  EXPECT_LT(std::abs(body.tree().u[2]), 0.01 * spin);
}

class Standing : public testing::TestWithParam<int> {};

// A Nao for 10 s on a box, on a ramp, on a tilted plane, between legs that give way a little.
TEST_P(Standing, ANaoStaysWhereItStands) {
  const double slope = GetParam() == 0 ? 0 : 3 * M_PI / 180;
  auto world = emptyWorld();
  if (GetParam() == 2) {
    world->ground_normal = tilted(slope);
  } else {
    world->obstacles = {ramp(slope)};
  }
  const auto model = test::robot("nao_h21_v33");
  World standing(world, {{"nao", model, {}}}, 2ms);
  const JointCommand command{model->findPosture("StandInit")->angle,
                             JointArray<double>(model->jointCount(), 1.0)};
  standing.placeRobot(0, {}, &command.angle);
  const auto hold = [&](int steps) {
    for (int k = 0; k < steps; ++k) {
      if (k % 5 == 0) standing.setCommand(0, command);
      standing.step();
    }
    return Vec3(standing.scene().robots[0].X_WB[0].translation());
  };
  const Vec3 before = hold(1000);
  if (GetParam() < 2) {
    EXPECT_GT(before.z(), 0.9);  // on top of it
  }
  const Vec3 after = hold(5000);
  EXPECT_LT((after - before).norm(), 1e-3);  // [m] as on level ground
  EXPECT_LT(standing.penetration(0), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(BoxRampPlane, Standing, testing::Values(0, 1, 2));

// On the flat top of a hull as on a box of the same size: to the last micrometre.
TEST(Obstacles, AHullBearsABlock) {
  std::vector<double> height;
  for (const bool hull : {false, true}) {
    auto world = emptyWorld();
    Obstacle table;
    table.shape.kind = hull ? Shape::Kind::Hull : Shape::Kind::Box;
    table.shape.size = Vec3(1, 1, 0.4);
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) {
      corners.emplace_back(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.2 : -0.2);
    }
    table.shape.hull = std::make_shared<const Hull>(calcHull(corners));
    table.shape.X_BS = translation(Vec3(0, 0, 0.2));
    world->obstacles = {table};
    RobotBody body({*test::block(1, Vec3(0.2, 0.2, 0.1)), *world});
    run(body, 2);
    height.push_back(body.tree().q[6]);
  }
  EXPECT_NEAR(height[0], 0.45, 1e-3);
  EXPECT_NEAR(height[1], height[0], 1e-6);
}

TEST(Obstacles, AFallingNaoLeansOnAWall) {
  auto world = emptyWorld();
  Obstacle wall;
  wall.shape.kind = Shape::Kind::Box;
  wall.shape.size = Vec3(0.2, 4, 2);
  wall.shape.X_BS = translation(Vec3(-0.3, 0, 1));
  world->obstacles = {wall};
  const auto model = test::robot("nao_h21_v33");
  World falling(world, {{"nao", model, {}}}, 2ms);
  const JointCommand command{model->findPosture("StandInit")->angle,
                             JointArray<double>(model->jointCount(), 1.0)};
  falling.placeRobot(0, {}, &command.angle);
  falling.push(0, Vec3(-15, 0, 0), 600ms);
  for (int k = 0; k < 2000; ++k) {
    if (k % 5 == 0) falling.setCommand(0, command);
    falling.step();
    ASSERT_GT(falling.scene().robots[0].X_WB[0].translation().x(), -0.2);  // never in the wall
  }
  EXPECT_TRUE(falling.healthy());
  EXPECT_LT(falling.penetration(0), 0.005);
}

}  // namespace
}  // namespace nao::sim
