#include "validation/log/standard_motions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/shape_gap.h"
#include "sim/world.h"
#include "tests/support/models.h"
#include "tests/support/shape_gap.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

constexpr double kCycle = 0.01;  // [s]

std::vector<JointArray<double>> play(const RobotModel& model, std::size_t motion, double cycle) {
  std::vector<JointArray<double>> angles;
  const int rows = static_cast<int>(kStandardMotionTime / cycle);
  for (int i = 0; i <= rows; ++i) angles.push_back(standardAngles(model, motion, i * cycle));
  return angles;
}

// The least gap between solids that may touch each other [m].
double calcLeastGap(const RobotModel& model, const JointArray<double>& angle, std::string& who) {
  const std::vector<Pose> X_RB = test::bodyPoses(model, angle);
  double least = 1;
  for (int a = 0; a < static_cast<int>(model.bodies.size()); ++a) {
    for (int b = a + 1; b < static_cast<int>(model.bodies.size()); ++b) {
      // The published range of the head keeps it clear of the shoulders; the solids are coarser.
      if (model.bodies[static_cast<std::size_t>(b)].name == "HeadPitch") continue;
      if (std::binary_search(model.no_collision.begin(), model.no_collision.end(),
                             std::pair(a, b))) {
        continue;
      }
      const Body& first = model.bodies[static_cast<std::size_t>(a)];
      const Body& second = model.bodies[static_cast<std::size_t>(b)];
      for (const Shape& mine : first.collisions) {
        for (const Shape& other : second.collisions) {
          const double gap =
              calcShapeGap(mine, X_RB[a] * mine.X_BS, other, X_RB[b] * other.X_BS).distance;
          if (gap < least) who = first.name + " and " + second.name;
          least = std::min(least, gap);
        }
      }
    }
  }
  return least;
}

class EveryNao : public ::testing::TestWithParam<const char*> {
 protected:
  const std::shared_ptr<const RobotModel> model_ = test::robot(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Robots, EveryNao,
                         ::testing::Values("nao_h21_v33", "nao_h25_v50", "nao_h25_v60"));

TEST_P(EveryNao, TouchesItselfInNoStandardMotion) {
  constexpr double kApart = 0.004;  // [m] what servos may lag and give way
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    double least = 1;
    std::string who, worst;
    double at = 0, t = 0;
    for (const auto& angle : play(*model_, m, 0.04)) {
      const double gap = calcLeastGap(*model_, angle, who);
      if (gap < least) worst = who, at = t;
      least = std::min(least, gap);
      t += 0.04;
    }
    EXPECT_GT(least, kApart) << standardMotions()[m].name << " at " << at << " s: " << worst;
  }
}

TEST_P(EveryNao, StaysInsideRangesAndCoupledLimits) {
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    for (const auto& angle : play(*model_, m, kCycle)) {
      for (std::size_t j = 0; j < model_->jointCount(); ++j) {
        ASSERT_GE(angle[j], model_->actuators[j].lower) << model_->actuators[j].name;
        ASSERT_LE(angle[j], model_->actuators[j].upper) << model_->actuators[j].name;
      }
      for (const CoupledLimit& limit : model_->coupled_limits) {
        const auto [low, high] = limit.rangeAt(angle[limit.driver]);
        ASSERT_GE(angle[limit.limited], low);
        ASSERT_LE(angle[limit.limited], high);
      }
    }
  }
}

TEST_P(EveryNao, IsNeverToldToMoveFasterThanItCan) {
  constexpr double kStep = 0.06;  // [rad] the small raw steps, while a coupled range moves
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    const auto angles = play(*model_, m, kCycle);
    for (std::size_t i = 1; i < angles.size(); ++i) {
      for (std::size_t j = 0; j < model_->jointCount(); ++j) {
        const double step = std::abs(angles[i][j] - angles[i - 1][j]);
        const double speed = model_->actuators[j].max_velocity;
        ASSERT_LE(step, kStep + 0.95 * speed * kCycle)
            << standardMotions()[m].name << " " << model_->actuators[j].name << " cycle " << i;
      }
    }
  }
}

// Raw steps are single rows; whatever lasts must leave the servo torque to follow.
TEST_P(EveryNao, LastsNowhereAtTopSpeed) {
  constexpr std::size_t kSteps = 10;  // rows of a motion
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    const auto angles = play(*model_, m, kCycle);
    for (std::size_t j = 0; j < model_->jointCount(); ++j) {
      const auto is_limited = [&](const CoupledLimit& limit) { return index(limit.limited) == j; };
      if (std::any_of(model_->coupled_limits.begin(), model_->coupled_limits.end(), is_limited)) {
        continue;
      }
      std::vector<double> speed;
      for (std::size_t i = 1; i < angles.size(); ++i) {
        speed.push_back(std::abs(angles[i][j] - angles[i - 1][j]) / kCycle);
      }
      std::nth_element(speed.begin(), speed.begin() + kSteps, speed.end(), std::greater<>());
      EXPECT_LE(speed[kSteps], 0.95 * model_->actuators[j].max_velocity)
          << standardMotions()[m].name << " " << model_->actuators[j].name;
    }
  }
}

double correlate(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
  for (std::size_t i = 0; i < a.size(); ++i) ma += a[i] / n, mb += b[i] / n;
  for (std::size_t i = 0; i < a.size(); ++i) {
    aa += (a[i] - ma) * (a[i] - ma), bb += (b[i] - mb) * (b[i] - mb);
    ab += (a[i] - ma) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

TEST(StandardMotions, NoTwoJointsMoveAlike) {
  const auto model = test::robot("nao_h21_v33");
  std::vector<std::vector<double>> all(model->jointCount());
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    for (const auto& angle : play(*model, m, kCycle)) {
      for (std::size_t j = 0; j < model->jointCount(); ++j) all[j].push_back(angle[j]);
    }
  }
  for (std::size_t a = 0; a < all.size(); ++a) {
    for (std::size_t b = a + 1; b < all.size(); ++b) {
      EXPECT_LT(std::abs(correlate(all[a], all[b])), 0.6)
          << model->actuators[a].name << " " << model->actuators[b].name;
    }
  }
}

TEST(StandardMotions, MoveEveryJointInEveryMotionAndComeBack) {
  const auto model = test::robot("nao_h21_v33");
  const JointArray<double> rest = standardRest(*model);
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    const auto angles = play(*model, m, kCycle);
    for (std::size_t j = 0; j < model->jointCount(); ++j) {
      double low = rest[j], high = rest[j];
      for (const auto& angle : angles) {
        low = std::min(low, angle[j]), high = std::max(high, angle[j]);
      }
      EXPECT_GT(high - low, 0.2) << standardMotions()[m].name << " " << model->actuators[j].name;
      EXPECT_EQ(angles.front()[j], rest[j]);
      EXPECT_NEAR(angles.back()[j], rest[j], 1e-9);
    }
  }
}

// A coupled limit shows only where a joint comes near to it while it is narrow.
TEST(StandardMotions, BringTheAnkleToItsNarrowPlacesInFitSelectAndTest) {
  const auto model = test::robot("nao_h21_v33");
  for (const CoupledLimit& limit : model->coupled_limits) {
    if (model->actuators[index(limit.limited)].name == "HeadPitch") continue;
    std::map<Split, int> rows;
    for (std::size_t m = 0; m < standardMotions().size(); ++m) {
      for (const auto& angle : play(*model, m, kCycle)) {
        const auto [low, high] = limit.rangeAt(angle[limit.driver]);
        const double gap = std::min(angle[limit.limited] - low, high - angle[limit.limited]);
        if (high - low < 0.5 && gap < 0.06) ++rows[standardMotions()[m].split];
      }
    }
    EXPECT_GT(rows[Split::Fit], 60);
    EXPECT_GT(rows[Split::Select], 10);
    EXPECT_GT(rows[Split::Test], 10);
  }
}

// With servos that lag and overshoot.
TEST(StandardMotions, TouchNothingWhenARobotWithHandsReallyPlaysThem) {
  const auto hung = std::make_shared<RobotModel>(suspend(*test::robot("nao_h25_v50")));
  for (std::size_t m = 0; m < standardMotions().size(); ++m) {
    const Duration step = std::chrono::milliseconds(2);
    sim::World world(test::flatWorld(), {{"robot", hung, {}}}, step);
    const JointArray<double> rest = standardRest(*hung);
    world.placeRobot(0, {}, &rest);
    for (double t = 0; t < kStandardMotionTime; t += toSeconds(hung->cycle)) {
      world.setCommand(0, {standardAngles(*hung, m, t), JointArray<double>(hung->jointCount(), 1)});
      for (Duration passed{}; passed < hung->cycle; passed += step) world.step();
      ASSERT_TRUE(world.contacts().forces.empty())
          << standardMotions()[m].name << " at " << t << " s";
    }
  }
}

}  // namespace
}  // namespace nao::validation
