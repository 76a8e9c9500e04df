#include "walk_engine/support.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::walk {
namespace {

constexpr double kMargin = 0.01;  // [m]

Support::Feet sideBySide(bool left, bool right) {
  Support::Feet feet;
  feet.places = {Pose2{0, 0.05, 0}, Pose2{0, -0.05, 0}};
  feet.stands = {left, right};
  return feet;
}

double depth(const std::vector<SupportEdge>& edges, const Eigen::Vector2d& p) {
  double depth = 1;
  for (const SupportEdge& edge : edges) depth = std::min(depth, edge.offset - edge.normal.dot(p));
  return depth;
}

TEST(Support, OfOneFootIsItsSoleDrawnIn) {
  const auto model = test::robot("nao_h21_v33");
  const Support support(*model, kMargin);
  const auto edges = support.edges(sideBySide(true, false), 0);
  Eigen::Vector2d low(1, 1), high(-1, -1);
  for (const Eigen::Vector2d& p : model->feet[0].outline) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d middle(0.5 * (low.x() + high.x()), 0.05 + 0.5 * (low.y() + high.y()));
  EXPECT_LT(depth(edges, {high.x() - 0.9 * kMargin, middle.y()}), 0);
  EXPECT_LT(depth(edges, {low.x() + 0.9 * kMargin, middle.y()}), 0);
  EXPECT_LT(depth(edges, {middle.x(), 0.05 + high.y() - 0.9 * kMargin}), 0);
  EXPECT_LT(depth(edges, {middle.x(), 0.05 + low.y() + 0.9 * kMargin}), 0);
  EXPECT_GT(depth(edges, {0, 0.05}), 0.02);
  EXPECT_LT(depth(edges, {0, 0}), 0);
}

TEST(Support, OfBothFeetHoldsWhatLiesBetweenThem) {
  const Support support(*test::robot("nao_h21_v33"), kMargin);
  const auto edges = support.edges(sideBySide(true, true), 0);
  for (const double y : {-0.05, 0.0, 0.05}) EXPECT_GT(depth(edges, {0.02, y}), 0.02);
}

TEST(Support, TurnsAndMovesWithTheFoot) {
  const Support support(*test::robot("nao_h21_v33"), kMargin);
  Support::Feet feet = sideBySide(true, false);
  const double before = depth(support.edges(feet, 0), {0.05, 0.06});
  feet.places[0] = {1, 2, M_PI / 2};  // the sole's x is now the floor's y
  EXPECT_NEAR(depth(support.edges(feet, 0), {1 - 0.01, 2 + 0.05}), before, 1e-12);
}

// An edge that lies on a landing moves with it, one between a landing and a standing foot by half.
TEST(Support, TakesEdgesAlongWithTheLandingTheyLieOn) {
  const Support support(*test::robot("nao_h21_v33"), kMargin);
  Support::Feet feet = sideBySide(true, true);
  feet.landing = {0, -1};
  int whole = 0, half = 0, fixed = 0;
  for (const SupportEdge& edge : support.edges(feet, 1)) {
    if (edge.share == 1) ++whole;
    if (edge.share == 0.5) ++half;
    if (edge.step < 0) ++fixed;
  }
  EXPECT_GT(whole, 2);
  EXPECT_EQ(half, 2);
  EXPECT_GT(fixed, 2);
  for (const SupportEdge& edge : support.edges(feet, 0)) EXPECT_EQ(edge.step, -1);
}

}  // namespace
}  // namespace nao::walk
