#include "validation/diagnosis/rig/yielding_inertia.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

constexpr double kDt = 0.002, kInertia = 0.01;  // [s], [kg m^2]

// Jolts of 40 Hz and 300 rad/s^2 on top of a slow swing, and neighbours that give way to them.
struct Jolted {
  explicit Jolted(double yield) : acceleration(1000), torque(1000), inertia(1000) {
    for (Eigen::Index i = 0; i < 1000; ++i) {
      const double t = kDt * static_cast<double>(i);
      const double jolt = 300 * std::sin(2 * M_PI * 40 * t);
      acceleration[i] = jolt + 10 * std::sin(2 * t);
      torque[i] = 0.5 + 0.1 * std::sin(t) - yield * jolt;
      inertia[i] = kInertia;
    }
    total = torque + inertia.cwiseProduct(acceleration);
    moveYieldToInertia(kDt, acceleration, torque, inertia);
  }
  Eigen::VectorXd acceleration, torque, inertia, total;
};

TEST(YieldingInertia, TakesFromTheInertiaWhatNeighboursTookFromTheTorque) {
  const Jolted jolted(0.4 * kInertia);
  const Eigen::VectorXd sum =
      jolted.torque + jolted.inertia.cwiseProduct(jolted.acceleration) - jolted.total;
  EXPECT_LT(sum.cwiseAbs().maxCoeff(), 1e-12);
  // Quiet accelerations count as noise of 20 rad/s^2: 1 % of the jolts' square.
  EXPECT_NEAR(jolted.inertia.segment(100, 800).mean(), 0.6 * kInertia, 0.02 * kInertia);
}

TEST(YieldingInertia, LeavesAFifth) {
  const Jolted jolted(3 * kInertia);
  EXPECT_GE(jolted.inertia.minCoeff(), kLeastOfInertia * kInertia * (1 - 1e-9));
}

TEST(YieldingInertia, NeverAddsAny) {
  const Jolted jolted(-0.4 * kInertia);
  EXPECT_LE(jolted.inertia.maxCoeff(), kInertia);
}

}  // namespace
}  // namespace nao::validation
