#include "validation/diagnosis/report/examined_joint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/jobs/packed.h"

namespace nao::validation {
namespace {

// A weak joint, of which a diagnosis says that it is weak, or its command late.
class Examined : public testing::Test {
 protected:
  Examined() : joint_(weak(), 1, test::kToyNoise, 3, 2), tasks_{{&joint_, test::kToyNoise}} {
    diagnosis_.joints.resize(1);
    JointVerdict& verdict = diagnosis_.joints[0];
    verdict.joint = joint_.joint();
    verdict.verdict = Verdict::Named;
    verdict.findings.resize(1);
    Finding& finding = verdict.findings[0];
    finding.effect = finding.cause = "kp_error";
    finding.numbers = {{"part", "", -0.5, -0.5, -0.5, -0.5}};
    finding.rivals = {
        whatHasNoName(),
        {"command_latency", "command_latency", "", {{"delay", "s", 0.02, 0.02, 0.02, 0.02}}, 1}};
  }
  static test::ToyLaws weak() {
    test::ToyLaws laws;
    laws.kp *= 0.5;
    return laws;
  }
  ExaminedJoint examined() const { return examineJoints(diagnosis_, tasks_, {}).at(0); }

  test::ToyJoint joint_;
  std::vector<JointTask> tasks_;
  SetDiagnosis diagnosis_;
};

double rms(const Eigen::VectorXd& x) {
  return std::sqrt(x.squaredNorm() / static_cast<double>(x.size()));
}

TEST_F(Examined, WhatWasFoundIsNearerThanItsRival) {
  const JointCourse course = examined().course;
  EXPECT_EQ(course.rival, "command_latency");  // "unknown" has no numbers
  EXPECT_LT(rms(course.measured - course.extended), rms(course.measured - course.with_rival));
  EXPECT_GT(rms(course.with_rival - course.nominal), 0);
  EXPECT_LT(examined().after.rmse, examined().before.rmse);
}

TEST_F(Examined, RunsSpreadAsTheNoiseHasThem) {
  const JointCourse course = examined().course;
  // Of 3 measured and 16 simulated runs of one noise: within a factor of two.
  EXPECT_LT(rms(course.measured_sd), 2 * rms(course.simulated_sd));
  EXPECT_GT(rms(course.measured_sd), rms(course.simulated_sd) / 2);
  EXPECT_EQ(drawCourse(course).panels.size(), 3u);
}

TEST_F(Examined, WithoutRivalsNoneIsDrawn) {
  const std::size_t with = drawCourse(examined().course).panels[1].series.size();
  diagnosis_.joints[0].findings[0].rivals.clear();
  const JointCourse course = examined().course;
  EXPECT_TRUE(course.rival.empty());
  EXPECT_EQ(drawCourse(course).panels[1].series.size() + 1, with);
}

TEST_F(Examined, IsTheSameAfterItWasKept) {
  const std::string bytes = pack(examined());
  EXPECT_EQ(pack(unpack<ExaminedJoint>(bytes)), bytes);
}

}  // namespace
}  // namespace nao::validation
