#include "validation/diagnosis/rig/touched_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/suspend.h"
#include "tests/support/models.h"
#include "validation/diagnosis/joint/prepared_set.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

TEST(TouchedLines, AreMetByNothingThatTheyWereMeasuredFrom) {
  const Eigen::VectorXd other = Eigen::VectorXd::LinSpaced(50, -1, 0.5);
  const Eigen::VectorXd left = (0.2 + other.array().square()).matrix();
  for (const double slope : {0.4, 2.0, -0.4, -2.0}) {
    const double place = touchingPlace({other, left}, slope);
    const Eigen::VectorXd room = left.array() - slope * (other.array() - place);
    EXPECT_NEAR(room.minCoeff(), 0, 1e-12) << slope;
  }
}

// One run that went further than the others of its motion tells nothing; a whole motion does.
TEST(TouchedLines, GoAsFarAsTheMedianRunOfTheMotionThatWentFurthest) {
  const auto run = [](double left) {
    return StopApproach{Eigen::VectorXd::Constant(1, 0.5), Eigen::VectorXd::Constant(1, left)};
  };
  const auto lines = touchedLines({{run(0.2), run(0.01), run(0.3)}, {run(0.4)}});
  EXPECT_EQ(lines.size(), 25u);  // one from zero, twelve slopes of either sign
  for (const auto& line : lines) {
    EXPECT_NEAR(line[0] * (0.5 - line[1]), 0.2, 1e-12) << line[0];
  }
}

constexpr double kSlope = -1, kPlace = 0.3;  // [rad/rad], [rad]: 0.6 rad inside at the most

LogSet recordStopped(const std::shared_ptr<const RobotModel>& model) {
  RecordingPlan plan;
  plan.model = model;
  plan.joints = {"LAnklePitch", "LAnkleRoll"};
  plan.motions = {standardRecording(model)[1]};
  moveOnly(plan.joints, model, plan.motions);
  plan.motions[0].angles = [all = plan.motions[0].angles, pitch = *model->findJoint("LAnklePitch"),
                            roll = *model->findJoint("LAnkleRoll")](double t) {
    JointArray<double> angle = all(t);
    angle[pitch] = -0.3 * std::sin(2 * t);
    angle[roll] = -0.2 - 0.1 * std::sin(3 * t);
    return angle;
  };
  plan.repeats = 3;
  plan.extra = {{"coupled_stop",
                 {{"upper", 0}, {"lower", kSlope}, {"place", kPlace}},
                 {*model->findJoint("LAnkleRoll")},
                 ""}};
  return recordSimulated(plan);
}

// The slopes of the row are a third apart, so that one is within a sixth of the hidden one; where
// the stop goes furthest inside, it is within some counts of 1.5 mrad.
TEST(TouchedLines, OfAJointOnARigGoWhereAHiddenStopWas) {
  const auto model = std::make_shared<RobotModel>(suspend(*test::robot("nao_h21_v33")));
  const PreparedSet set = prepareSet(recordStopped(model), model, 1);
  ASSERT_EQ(set.joints.size(), 2u);
  for (const PreparedJoint& joint : set.joints) {
    const auto lines = joint.simulator->touchedLines(false);
    if (joint.simulator->joint() == "LAnklePitch") {
      EXPECT_TRUE(lines.empty());
      continue;
    }
    const auto nearest =
        std::min_element(lines.begin(), lines.end(), [](const auto& a, const auto& b) {
          return std::abs(a[0] - kSlope) < std::abs(b[0] - kSlope);
        });
    ASSERT_NE(nearest, lines.end());
    EXPECT_NEAR((*nearest)[0], kSlope, std::abs(kSlope) / 6);
    EXPECT_NEAR((*nearest)[0] * (-0.3 - (*nearest)[1]), kSlope * (-0.3 - kPlace), 0.02);
  }
}

}  // namespace
}  // namespace nao::validation
