#include "motion/trajectory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::motion {
namespace {

constexpr double kExact = 1e-9;  // arithmetic and 48 halvings

Key keyAt(double time, double angle) {
  Key key;
  key.time = time;
  key.angle = angle;
  return key;
}

double speedAt(const Trajectory& trajectory, double time) {
  constexpr double kStep = 1e-5;
  return (trajectory.at(time + kStep) - trajectory.at(time - kStep)) / (2 * kStep);
}

TEST(Trajectory, PassesThroughItsKeysAndHoldsItsEnds) {
  std::vector<Key> keys = {keyAt(0.5, 1), keyAt(1, -0.5), keyAt(2, 0.25)};
  setAutoHandles(0.1, keys);
  const Trajectory trajectory(0.1, keys);
  EXPECT_NEAR(trajectory.at(0), 0.1, kExact);
  EXPECT_NEAR(trajectory.at(0.5), 1, kExact);
  EXPECT_NEAR(trajectory.at(1), -0.5, kExact);
  EXPECT_NEAR(trajectory.at(2), 0.25, kExact);
  EXPECT_NEAR(trajectory.at(7), 0.25, kExact);
  EXPECT_NEAR(trajectory.at(-1), 0.1, kExact);
  EXPECT_DOUBLE_EQ(trajectory.duration(), 2);
}

TEST(Trajectory, OneAutomaticKeyIsTheCubicWithLevelEnds) {
  std::vector<Key> keys = {keyAt(2, 1)};
  setAutoHandles(0, keys);
  const Trajectory trajectory(0, keys);
  for (const double part : {0.1, 0.25, 0.5, 0.8}) {
    EXPECT_NEAR(trajectory.at(2 * part), part * part * (3 - 2 * part), 1e-6);
  }
}

TEST(Trajectory, IsLevelAtExtremaAndSmoothBetween) {
  std::vector<Key> keys = {keyAt(1, 0.2), keyAt(2, 1), keyAt(3, 0.5)};
  setAutoHandles(0, keys);
  const Trajectory trajectory(0, keys);
  EXPECT_NEAR(speedAt(trajectory, 2), 0, 1e-3);
  // The slope at a key on a rising stretch is that of its neighbours, from either side.
  EXPECT_NEAR(speedAt(trajectory, 1 - 2e-5), 0.5, 0.01);
  EXPECT_NEAR(speedAt(trajectory, 1 + 2e-5), 0.5, 0.01);
}

TEST(Trajectory, AutomaticHandlesNeverOvershoot) {
  std::vector<Key> keys = {keyAt(1, 0.01), keyAt(2, 1), keyAt(2.1, 1.01), keyAt(4, 1.01)};
  setAutoHandles(0, keys);
  const Trajectory trajectory(0, keys);
  double before = 0;
  for (double time = 0; time < 4; time += 0.002) {
    const double now = trajectory.at(time);
    EXPECT_GE(now, before - kExact) << time;
    EXPECT_LE(now, 1.01 + kExact) << time;
    before = now;
  }
}

TEST(Trajectory, FollowsExplicitHandles) {
  // Handles along the chord at thirds make a straight line.
  Key first = keyAt(1, 0);
  first.after = {Handle::Kind::Bezier, 1.0 / 3, 1.0 / 3};
  Key second = keyAt(2, 1);
  second.before = {Handle::Kind::Bezier, -1.0 / 3, -1.0 / 3};
  const Trajectory line(0, {first, second});
  EXPECT_NEAR(line.at(1.25), 0.25, kExact);
  // A handle that leaves level and late keeps the value near its key for longer.
  first.after = {Handle::Kind::Bezier, 0.9, 0};
  const Trajectory late(0, {first, second});
  EXPECT_LT(late.at(1.5), 0.4);
}

TEST(Trajectory, KnowsLinearAndConstantPieces) {
  Key first = keyAt(1, 0);
  Key second = keyAt(2, 1);
  first.after.kind = Handle::Kind::Linear;
  second.before.kind = Handle::Kind::Linear;
  EXPECT_NEAR(Trajectory(0, {first, second}).at(1.7), 0.7, kExact);
  first.after.kind = Handle::Kind::Constant;
  EXPECT_NEAR(Trajectory(0, {first, second}).at(1.99), 0, kExact);
  EXPECT_NEAR(Trajectory(0, {first, second}).at(2), 1, kExact);
}

TEST(Trajectory, CutsHandlesLongerThanTheirInterval) {
  Key first = keyAt(1, 0);
  first.after = {Handle::Kind::Bezier, 50, 0};
  Key second = keyAt(2, 1);
  second.before = {Handle::Kind::Bezier, -50, 0};
  const Trajectory trajectory(0, {first, second});
  double before = 0;
  for (double time = 1; time <= 2; time += 0.01) {
    EXPECT_GE(trajectory.at(time), before - kExact) << time;
    before = trajectory.at(time);
  }
}

}  // namespace
}  // namespace nao::motion
