#include "validation/diagnosis/diagnosis_page.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

std::string pageOf(int repeats) {
  SetDiagnosis diagnosis;
  diagnosis.joints.resize(1);
  diagnosis.joints[0].joint = "HeadYaw";
  diagnosis.joints[0].repeats = repeats;
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

}  // namespace
}  // namespace nao::validation
