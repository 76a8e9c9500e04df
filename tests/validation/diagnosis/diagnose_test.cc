#include "validation/diagnosis/diagnose.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/diagnosis_json.h"

namespace nao::validation {
namespace {

using test::ToyJoint;
using test::ToyLaws;

DiagnosisOptions quick(int jobs) {
  DiagnosisOptions options;
  options.jobs = jobs;
  options.effort = {4, 8, 24, 40, 4, 1, 1};
  return options;
}

SetDiagnosis diagnose(const std::vector<ToyLaws>& truths, DiagnosisOptions options = quick(2)) {
  std::vector<ToyJoint> joints;
  for (std::size_t j = 0; j < truths.size(); ++j) {
    joints.emplace_back(truths[j], j + 1, test::kToyNoise, 6, 3, "Toy" + std::to_string(j));
  }
  std::vector<JointTask> tasks;
  for (const ToyJoint& joint : joints) tasks.push_back({&joint, test::kToyNoise});
  return diagnoseJoints(tasks, test::toyCauses(), options);
}

ToyLaws late() {
  ToyLaws laws;
  laws.latency += 0.012;
  return laws;
}

TEST(Diagnose, SaysOnceWhatAllJointsShare) {
  const SetDiagnosis found = diagnose({late(), late()});
  ASSERT_EQ(found.shared.size(), 1u);
  const Finding& finding = found.shared[0].finding;
  EXPECT_TRUE(finding.cause == "command_latency" || finding.cause == "sensor_delay");
  // To a heavy joint seen by its angle alone a hold is late by half of itself.
  ASSERT_EQ(finding.rivals.size(), 1u);
  EXPECT_EQ(finding.rivals[0].cause, "command_hold");
  EXPECT_NEAR(finding.rivals[0].numbers[0].deviation, 2 * 0.012, 0.003);
  EXPECT_NEAR(finding.numbers[0].deviation, 0.012, 0.001);
  for (const JointVerdict& joint : found.joints) EXPECT_TRUE(joint.named().empty());
}

TEST(Diagnose, NamesAJointsOwnFaultThereAlone) {
  ToyLaws weak;
  weak.kp *= 0.7;
  const SetDiagnosis found = diagnose({weak, {}});
  EXPECT_TRUE(found.shared.empty());
  ASSERT_EQ(found.joints[0].named().size(), 1u);
  EXPECT_EQ(found.joints[0].named()[0]->cause, "kp_error");
  EXPECT_TRUE(found.joints[1].named().empty());
}

TEST(Diagnose, SaysTheSameWithAnyNumberOfThreads) {
  ToyLaws weak;
  weak.kp *= 0.8;
  DiagnosisOptions one = quick(1), two = quick(2);
  one.effort = two.effort = {2, 4, 8, 12, 2, 1, 1};
  EXPECT_EQ(toJson(diagnose({weak, {}}, one), {}), toJson(diagnose({weak, {}}, two), {}));
}

}  // namespace
}  // namespace nao::validation
