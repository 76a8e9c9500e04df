#include "validation/diagnosis/signature.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/joint_search.h"

namespace nao::validation {
namespace {

using test::ToyLaws;

// The signature of a joint with laws that no cause here explains.
std::string signature(const ToyLaws& truth) {
  const test::ToyJoint toy(truth, 3);
  std::vector<Cause> causes;
  for (const Cause& cause : test::toyCauses()) {
    if (cause.id == "viscous_friction") causes.push_back(cause);
  }
  JointSearch search(toy, test::kToyNoise, causes, {4, 8, 24, 40, 1, 1, 1}, 1000000);
  search.begin();
  return signatureOf(toy, search.data(), search.stage(), {}).text();
}

TEST(Signature, FindsTheRippleOfACoggingMotor) {
  ToyLaws laws;
  laws.cogging = 0.15;
  laws.cogs = 18;
  EXPECT_EQ(signature(laws).rfind("sin and cos of 18 q", 0), 0u) << signature(laws);
}

TEST(Signature, FindsAHumInTime) {
  ToyLaws laws;
  laws.hum = 0.1;
  EXPECT_EQ(signature(laws).rfind("sin and cos of 3.1 Hz", 0), 0u) << signature(laws);
}

TEST(Signature, FindsDragThatGrowsWithTheSquareOfSpeed) {
  ToyLaws laws;
  laws.drag = 0.1;
  EXPECT_EQ(signature(laws).rfind("v|v|", 0), 0u) << signature(laws);
}

TEST(Signature, FindsAGainThatGrows) {
  ToyLaws laws;
  laws.rise = 0.1;
  EXPECT_EQ(signature(laws).rfind("t e", 0), 0u) << signature(laws);
}

TEST(Signature, FindsAnEccentricEncoder) {
  ToyLaws laws;
  laws.eccentric = 0.05;
  EXPECT_EQ(signature(laws).rfind("misreading by sin and cos of 3 q", 0), 0u) << signature(laws);
}

TEST(Signature, FindsASpotThatSticks) {
  ToyLaws laws;
  laws.spot = 0.4;
  EXPECT_EQ(signature(laws).rfind("sgn v near q = 0.3", 0), 0u) << signature(laws);
}

TEST(Signature, FindsASpeedAtWhichAGearBrakes) {
  ToyLaws laws;
  laws.band = 0.3;
  const std::string found = signature(laws);  // speeds of the library: 0.82 is the nearest
  EXPECT_EQ(found.rfind("sgn v near |v| = 0.", 0), 0u) << found;
}

TEST(Signature, FindsNothingWhereNothingIs) { EXPECT_EQ(signature({}), ""); }

}  // namespace
}  // namespace nao::validation
