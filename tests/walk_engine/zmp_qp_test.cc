#include "walk_engine/zmp_qp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::walk {
namespace {

constexpr double kHeight = 0.26;  // [m]
constexpr double kGravity = 9.80665;
constexpr double kStep = 0.4;   // [s] single support; no double support, the hardest case
constexpr double kTick = 0.02;  // [s]
constexpr double kHalfLength = 0.07, kHalfWidth = 0.035;  // [m] of a foot

// Walking on the spot and forward: foot i stands from i * kStep on, left and right in turn.
struct Walk {
  double length = 0.04;
  std::vector<Eigen::Vector2d> moved = std::vector<Eigen::Vector2d>(100, Eigen::Vector2d::Zero());

  Eigen::Vector2d foot(int i) const {
    Eigen::Vector2d place(length * i, i % 2 ? -0.05 : 0.05);
    for (int k = 0; k <= i; ++k) place += moved[static_cast<std::size_t>(k)];
    return place;
  }
  // `landings` steps after the one that stands at `now` may be moved.
  std::vector<ZmpSample> preview(double now, int landings) const {
    std::vector<ZmpSample> samples;
    const int standing = static_cast<int>(std::floor(now / kStep + 1e-9));
    double t = now;
    for (const double dt :
         {0.02, 0.02, 0.02, 0.02, 0.02, 0.05, 0.05, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1}) {
      t += dt;
      const int i = static_cast<int>(std::floor(t / kStep + 1e-9));
      ZmpSample sample;
      sample.dt = dt;
      sample.reference = foot(i);
      sample.step = std::min(i - standing, landings) - 1;  // what moves one, moves all after it
      sample.share = sample.step >= 0 ? 1 : 0;
      for (const Eigen::Vector2d& normal : {Eigen::Vector2d(1, 0), Eigen::Vector2d(-1, 0),
                                            Eigen::Vector2d(0, 1), Eigen::Vector2d(0, -1)}) {
        const double half = normal.x() != 0 ? kHalfLength : kHalfWidth;
        sample.support.push_back(
            {normal, normal.dot(sample.reference) + half, sample.step, sample.share});
      }
      samples.push_back(sample);
    }
    return samples;
  }
};

struct Result {
  double beyond = 0;    // [m] farthest the zero moment point came out of the standing foot
  double farthest = 0;  // [m] of the capture point from the standing foot
  int infeasible = 0;
  double moved = 0;  // [m] all displacements
};

// `seconds` of walking; `push` [m/s] changes the velocity at 2.1 s.
Result walk(double seconds, const Eigen::Vector2d& push, int landings) {
  ZmpQp qp(kHeight, kGravity);
  Walk plan;
  ComState com;
  com.y[0] = 0.02;
  Result result;
  const double reach = 0.08;
  for (int tick = 0; tick * kTick < seconds; ++tick) {
    const double now = tick * kTick;
    if (tick == 105) {
      com.x[1] += push.x();
      com.y[1] += push.y();
    }
    const std::vector<LandingRange> ranges(
        static_cast<std::size_t>(landings),
        LandingRange{Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX(),
                     Eigen::Vector2d(-reach, -reach), Eigen::Vector2d(reach, reach)});
    const std::vector<ZmpSample> samples = plan.preview(now, landings);
    const CaptureGoal end{samples.back().reference, samples.back().step, samples.back().support};
    const ZmpQp::Plan step = qp.solve(com, samples, end, ranges);
    if (!step.feasible) ++result.infeasible;
    com = ZmpQp::carryOn(com, step.jerk, kTick);
    const int standing = static_cast<int>(std::floor((now + kTick) / kStep + 1e-9));
    const int before = static_cast<int>(std::floor(now / kStep + 1e-9));
    if (landings > 0 && standing > before) {  // it lands where the last plan wanted it
      plan.moved[static_cast<std::size_t>(standing)] = step.moved[0];
      result.moved += step.moved[0].norm();
    }
    const Eigen::Vector2d off = qp.calcZmp(com) - plan.foot(standing);
    result.beyond =
        std::max({result.beyond, std::abs(off.x()) - kHalfLength, std::abs(off.y()) - kHalfWidth});
    result.farthest =
        std::max(result.farthest, (qp.calcCapturePoint(com) - plan.foot(standing)).norm());
  }
  return result;
}

TEST(ZmpQp, WalksWithTheZeroMomentPointInsideTheFeet) {
  const Result result = walk(8, Eigen::Vector2d::Zero(), 0);
  EXPECT_EQ(result.infeasible, 0);
  EXPECT_LT(result.beyond, 1e-9);
  EXPECT_LT(result.farthest, 0.12);
}

TEST(ZmpQp, LeavesLandingsAloneThatNeedNoHelp) {
  const Result result = walk(8, Eigen::Vector2d::Zero(), 2);
  EXPECT_LT(result.moved, 0.02);  // [m] over twenty landings
}

// 0.2 m/s more is 3 cm of capture point, beyond the foot: without moving a landing no zero moment
// point inside the feet brings it back.
TEST(ZmpQp, StepsAsideWhenPushed) {
  for (const Eigen::Vector2d& push : {Eigen::Vector2d(0.45, 0), Eigen::Vector2d(0, 0.2),
                                      Eigen::Vector2d(0, -0.2), Eigen::Vector2d(-0.45, 0)}) {
    const Result stiff = walk(6, push, 0);
    const Result stepping = walk(6, push, 2);
    EXPECT_GT(stiff.infeasible, 0);
    EXPECT_EQ(stepping.infeasible, 0);
    EXPECT_GT(stepping.moved, 0.002);
    EXPECT_LT(stepping.beyond, 1e-9);
    EXPECT_LT(stepping.farthest, 0.2);
  }
}

}  // namespace
}  // namespace nao::walk
