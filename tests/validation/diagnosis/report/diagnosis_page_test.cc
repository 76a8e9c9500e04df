#include "validation/diagnosis/report/diagnosis_page.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

std::string pageOf(int repeats, const std::vector<Adjustment>& adjustments = {}) {
  SetDiagnosis diagnosis;
  diagnosis.joints.resize(1);
  diagnosis.joints[0].joint = "HeadYaw";
  diagnosis.joints[0].repeats = repeats;
  diagnosis.joints[0].adjustments = adjustments;
  Provenance provenance;
  provenance.test_openings = 2;
  return diagnosisPage(diagnosis, {ExaminedJoint{}}, provenance);
}

bool says(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

TEST(DiagnosisPage, SaysWhatTheVerdictStandsOn) {
  EXPECT_TRUE(says(pageOf(6), "(6 or more were measured)"));
  EXPECT_TRUE(says(pageOf(6), "opened them 2 times"));
}

TEST(DiagnosisPage, OfSingleRunsClaimsNoNoiseThatWasFitted) {
  EXPECT_TRUE(says(pageOf(1), "Motions were run once"));
  EXPECT_FALSE(says(pageOf(1), "or more were measured"));
}

TEST(DiagnosisPage, ListsSmallDifferences) {
  const Adjustment offset{
      "encoder_offset", "encoder_offset", {"angle", "rad", 1e-3, 1e-3, 5e-4, 1.5e-3}};
  EXPECT_TRUE(says(pageOf(6, {offset}), "<td>encoder_offset</td><td>0.0573 deg</td>"));
  EXPECT_FALSE(says(pageOf(6), "encoder_offset"));
}

}  // namespace
}  // namespace nao::validation
