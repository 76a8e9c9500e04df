#include "validation/diagnosis/next_experiment.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"

namespace nao::validation {
namespace {

std::shared_ptr<const RobotModel> pendulum() { return nao::test::robot("xl330_pendulum"); }

// Dry friction and grease: alike at one speed only.
AmbiguousJoint ambiguous() {
  const std::vector<Joint> joint{toJoint(0)};
  return {"pendulum",
          {"coulomb_friction", "viscous_friction"},
          {{"coulomb_friction", {{"torque", 0.03}}, joint, ""},
           {"viscous_friction", {{"coefficient", 0.03}}, joint, ""}},
          ""};
}

TEST(NextExperiment, TakesTheMotionThatSeparatesMost) {
  const auto found = planExperiments(pendulum(), ambiguous(), 6, 1);
  ASSERT_GE(found.size(), 5u);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_GE(found[i - 1].separation, found[i].separation);
  }
  EXPECT_GT(found.front().separation, 2 * found.back().separation);
}

TEST(NextExperiment, WritesAMotionThatPlays) {
  const auto model = nao::test::robot("nao_h21_v33");
  const auto motions = candidateMotions(model, *model->findJoint("LKneePitch"));
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/next.motion";
  writeMotion(motions.front(), *model, file);
  const motion::Timeline timeline = motion::loadMotion(file, *model);
  EXPECT_FALSE(timeline.curves.empty());
}

TEST(NextExperiment, ReadsWhatAReportCouldNotDecide) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("report.json", R"({"joints": [{"joint": "pendulum", "findings": [
    {"cause": "torque_bias", "effect": "torque_bias", "experiment": "turn the base",
     "numbers": [{"parameter": "torque", "value": 0.02}],
     "rivals": [{"cause": "encoder_offset", "numbers": [{"parameter": "angle", "value": 0.1}]}]}
  ]}]})");
  const auto found = ambiguousJoints(file, *pendulum());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].causes, (std::vector<std::string>{"torque_bias", "encoder_offset"}));
  EXPECT_DOUBLE_EQ(found[0].settings[1].parameters.at("angle"), 0.1);
  folder.write("report.json", R"({"joints": []})");
  EXPECT_THROW(ambiguousJoints(file, *pendulum()), InputError);
}

}  // namespace
}  // namespace nao::validation
