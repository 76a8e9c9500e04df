#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "tests/support/models.h"
#include "tests/support/shape_gap.h"

// The collision solids of every shipped robot, held against its postures.
namespace nao {
namespace {

std::vector<std::string> shippedRobots() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(NAO_SOURCE_DIR "/robots")) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class EveryRobot : public ::testing::TestWithParam<std::string> {
 protected:
  bool mayTouch(int a, int b) const {
    return !std::binary_search(model_->no_collision.begin(), model_->no_collision.end(),
                               std::pair(a, b));
  }
  /// The motors that move two bodies against each other.
  std::set<Joint> motorsBetween(int a, int b) const {
    std::set<Joint> motors;
    while (a != b) {
      int& outer = a > b ? a : b;  // a parent always comes before its children
      motors.insert(model_->coordinates[static_cast<std::size_t>(outer - 1)].joint);
      outer = model_->bodies[static_cast<std::size_t>(outer)].parent;
    }
    return motors;
  }
  /// The smallest gap of two bodies, while one motor goes through its range.
  double leastGap(int a, int b, Joint motor) const {
    constexpr int kSteps = 20;
    const Actuator& actuator = model_->actuators[index(motor)];
    JointArray<double> angle(model_->jointCount(), 0.0);
    double least = 1;
    for (int i = 0; i <= kSteps; ++i) {
      const double part = static_cast<double>(i) / kSteps;
      angle[motor] = actuator.lower + part * (actuator.upper - actuator.lower);
      const auto X_RB = test::bodyPoses(*model_, angle);
      least = std::min(least, test::bodyGap(*model_, X_RB, a, b));
    }
    return least;
  }
  const std::shared_ptr<const RobotModel> model_ = test::robot(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Robots, EveryRobot, ::testing::ValuesIn(shippedRobots()),
                         [](const auto& test) { return test.param; });

TEST_P(EveryRobot, TouchesItselfInNoPosture) {
  constexpr double kApart = 0.0005;  // [m] the tolerance of the gap, and what servos give way
  const int bodies = static_cast<int>(model_->bodies.size());
  for (const Posture& posture : model_->postures) {
    const auto X_RB = test::bodyPoses(*model_, posture.angle);
    for (int a = 0; a < bodies; ++a) {
      for (int b = a + 1; b < bodies; ++b) {
        if (!mayTouch(a, b)) continue;
        EXPECT_GT(test::bodyGap(*model_, X_RB, a, b), kApart)
            << posture.name << ": " << model_->bodies[static_cast<std::size_t>(a)].name << " and "
            << model_->bodies[static_cast<std::size_t>(b)].name;
      }
    }
  }
}

// As a motor's range is published, it can be used: what moves by it alone, as the two sides of the
// hip do, must not be in its way.
TEST_P(EveryRobot, TurnsWhatOneMotorMovesThroughItsWholeRange) {
  const int bodies = static_cast<int>(model_->bodies.size());
  for (int a = 0; a < bodies; ++a) {
    for (int b = a + 1; b < bodies; ++b) {
      if (!mayTouch(a, b)) continue;
      const std::set<Joint> motors = motorsBetween(a, b);
      if (motors.size() != 1) continue;
      EXPECT_GT(leastGap(a, b, *motors.begin()), 0)
          << model_->bodies[static_cast<std::size_t>(a)].name << " and "
          << model_->bodies[static_cast<std::size_t>(b)].name;
    }
  }
}

}  // namespace
}  // namespace nao
