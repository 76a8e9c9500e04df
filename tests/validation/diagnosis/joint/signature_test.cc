#include "validation/diagnosis/joint/signature.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {
namespace {

using test::ToyLaws;

std::vector<Cause> frictionOnly() {
  std::vector<Cause> causes;
  for (const Cause& cause : test::toyCauses()) {
    if (cause.id == "viscous_friction") causes.push_back(cause);
  }
  return causes;
}

// What the remainder of a joint with laws that no cause here explains goes with first.
std::string firstFeature(const ToyLaws& truth) {
  const test::ToyJoint toy(truth, 3);
  JointSearch search(toy, test::kToyNoise, frictionOnly(), {4, 8, 24, 40, 1, 1, 1}, 1000000);
  search.begin();
  const Signature found = signatureOf(toy, search.data(), search.stage(), {});
  return found.terms.empty() ? "" : found.terms.front().feature;
}

TEST(Signature, FindsTheRippleOfACoggingMotor) {
  ToyLaws laws;
  laws.cogging = 0.15;
  laws.cogs = 18;
  EXPECT_EQ(firstFeature(laws), "sin and cos of 18 q");
}

TEST(Signature, FindsAHumInTime) {
  ToyLaws laws;
  laws.hum = 0.1;
  EXPECT_EQ(firstFeature(laws), "sin and cos of 3.1 Hz");
}

TEST(Signature, FindsDragThatGrowsWithTheSquareOfSpeed) {
  ToyLaws laws;
  laws.drag = 0.1;
  EXPECT_EQ(firstFeature(laws), "v|v|");
}

TEST(Signature, FindsAGainThatGrows) {
  ToyLaws laws;
  laws.rise = 0.1;
  EXPECT_EQ(firstFeature(laws), "t e");
}

TEST(Signature, FindsAnEccentricEncoder) {
  ToyLaws laws;
  laws.eccentric = 0.05;
  EXPECT_EQ(firstFeature(laws), "misreading by sin and cos of 3 q");
}

TEST(Signature, FindsASpotThatSticks) {
  ToyLaws laws;
  laws.spot = 0.4;
  EXPECT_EQ(firstFeature(laws), "sgn v near q = 0.3");
}

TEST(Signature, FindsASpeedAtWhichAGearBrakes) {
  ToyLaws laws;
  laws.band = 0.3;
  EXPECT_EQ(firstFeature(laws), "sgn v near |v| = 0.81");  // of the library's speeds
}

// Viscous friction explains most of it; of what is left beside it a brake at high speed.
TEST(Signature, IsThatOfAllThatHasNoNameNotOfWhatACauseLeaves) {
  ToyLaws laws;
  laws.drag = 0.1;
  const test::ToyJoint toy(laws, 3);
  JointSearch search(toy, test::kToyNoise, frictionOnly(), {4, 8, 24, 40, 1, 1, 1}, 1000000);
  search.begin();
  const JointVerdict verdict = search.conclude({});
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_EQ(verdict.signature.substr(0, 4), "v|v|") << verdict.signature;
}

// By its mean friction alone a brake at a hip went with nothing, as sets in which nothing is wrong
// go with friction by as much.
TEST(Signature, FindsABrakeThatComesAndGoes) {
  ToyLaws laws;
  laws.pulse = 0.4;
  EXPECT_EQ(firstFeature(laws), "sgn v with sin and cos of 0.5 Hz");
}

// An encoder that reads up to 0.09 rad wrong let a shoulder meet its stop: those rows, a sixth,
// were five sixths of what remained, and nothing was found that it goes with.
TEST(Signature, LeavesOutWhereAStopMayHoldTheJoint) {
  Eigen::MatrixXd motion(5, 2);
  motion << -1.2, 0, -1.2, -0.3, 0.5, 0, 1.9, 0.01, 1.8, 0;
  EXPECT_EQ(rowsOffStops(motion, {-1.3, 2.0}), (std::vector<Eigen::Index>{1, 2, 4}));
}

TEST(Signature, FindsNothingWhereNothingIs) { EXPECT_EQ(firstFeature({}), ""); }

}  // namespace
}  // namespace nao::validation
