#include "walk_engine/preview_control.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace nao::walk {
namespace {

constexpr double kHeight = 0.26;      // [m]
constexpr double kGravity = 9.80665;  // [m/s^2]
constexpr double kDt = 0.01;          // [s]

class PreviewControlTest : public testing::Test {
 protected:
  using Reference = double (*)(double);

  // Follows `zmp` of time for `seconds`; the largest distance from it after `settled`.
  double follow(Reference zmp, double offset, double seconds, double settled) {
    std::vector<double> ahead(static_cast<std::size_t>(control_.samples()) + 1);
    double worst = 0;
    for (int k = 0; k * kDt < seconds; ++k) {
      for (std::size_t j = 0; j < ahead.size(); ++j) {
        ahead[j] = offset + zmp((k + static_cast<int>(j)) * kDt);
      }
      if (k * kDt > settled) {
        worst = std::max(worst, std::abs(control_.calcZmp(state_) - ahead[0]));
      }
      control_.step(ahead, state_);
    }
    return worst;
  }

  const PreviewControl control_{kHeight, kGravity, kDt, 120};
  PreviewControl::State state_;
};

// From side to side every 0.42 s, a third of it moving.
double sway(double t) {
  if (t < 1) return 0;
  const double phase = std::fmod(t - 1, 0.84);
  const auto ramp = [](double s) { return std::clamp(s / 0.14, 0.0, 1.0); };
  return phase < 0.42 ? -0.05 + 0.1 * ramp(phase) : 0.05 - 0.1 * ramp(phase - 0.42);
}

TEST_F(PreviewControlTest, StaysAtRestOverARestingReference) {
  state_.position = 0.3;
  EXPECT_NEAR(follow([](double) { return 0.0; }, 0.3, 2, 0), 0, 1e-12);
  EXPECT_NEAR(state_.velocity, 0, 1e-12);
}

TEST_F(PreviewControlTest, FollowsAWalkWithinMillimetres) {
  // A sole is 38 to 50 mm wide on each side of the ankle: a fifth of the lesser is no danger.
  EXPECT_LT(follow(sway, 0, 8, 2), 0.0076);
}

TEST_F(PreviewControlTest, MovesTheMassLessThanTheZmp) {
  follow(sway, 0, 8, 0);
  double widest = 0;
  std::vector<double> ahead(static_cast<std::size_t>(control_.samples()) + 1);
  for (int k = 800; k < 900; ++k) {
    for (std::size_t j = 0; j < ahead.size(); ++j) {
      ahead[j] = sway((k + static_cast<int>(j)) * kDt);
    }
    control_.step(ahead, state_);
    widest = std::max(widest, std::abs(state_.position));
  }
  EXPECT_GT(widest, 0.01);
  EXPECT_LT(widest, 0.04);  // a pendulum at 2.4 rad half a period apart swings well inside +-0.05
}

TEST_F(PreviewControlTest, IsTheSameWalkFarFromTheOrigin) {
  PreviewControl::State near;
  follow(sway, 0, 5, 0);
  std::swap(near, state_);
  state_.position = 100;
  follow(sway, 100, 5, 0);
  EXPECT_NEAR(state_.position - 100, near.position, 1e-9);
  EXPECT_NEAR(state_.velocity, near.velocity, 1e-9);
}

TEST_F(PreviewControlTest, ObeysTheCartTableEquation) {
  follow(sway, 0, 3, 0);
  EXPECT_DOUBLE_EQ(control_.calcZmp(state_),
                   state_.position - kHeight / kGravity * state_.acceleration);
}

TEST(PreviewControl, SolvesAnyCycleAndHeightItMayMeet) {
  for (const double dt : {0.005, 0.01, 0.012, 0.02}) {
    for (const double height : {0.15, 0.26, 0.8}) {
      const PreviewControl control(height, kGravity, dt, static_cast<int>(1.2 / dt));
      PreviewControl::State state;
      const std::vector<double> ahead(static_cast<std::size_t>(control.samples()) + 1, 0.1);
      for (double t = 0; t < 5; t += dt) control.step(ahead, state);
      EXPECT_NEAR(state.position, 0.1, 1e-4) << dt << ' ' << height;
    }
  }
}

}  // namespace
}  // namespace nao::walk
