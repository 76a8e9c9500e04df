#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

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

}  // namespace
}  // namespace nao
