#include "tests/hidden/score.h"

#include <gtest/gtest.h>

namespace nao::hidden {
namespace {

Truth hiding(const std::string& cause, const std::string& joint = "HeadYaw") {
  Truth truth;
  truth.kind = Kind::Single;
  truth.joints = {"HeadYaw", "HeadPitch"};
  HiddenTruth hidden;
  hidden.cause = cause;
  hidden.parameter = "part";
  hidden.joint = joint;
  hidden.value = hidden.deviation = 0.2;
  hidden.features = {"v|v|"};
  truth.hidden = {hidden};
  return truth;
}

GivenCause named(const std::string& cause, const std::string& joint = "HeadYaw",
                 std::vector<std::string> rivals = {}) {
  GivenCause given;
  given.cause = cause;
  given.joint = joint;
  given.rivals = std::move(rivals);
  return given;
}

GivenReport saying(const std::string& verdict, std::vector<GivenCause> causes = {}) {
  GivenReport report;
  report.verdict = verdict;
  report.causes = std::move(causes);
  report.joints = {{"HeadYaw", verdict, "q (31 %), then v|v| (20 %)"}};
  return report;
}

TEST(Score, TheFirstCauseIsTheTruthAtItsJoint) {
  EXPECT_TRUE(score(hiding("kp_error"), saying("named", {named("kp_error")})).exact);
  const Score elsewhere =
      score(hiding("kp_error"), saying("named", {named("kp_error", "HeadPitch")}));
  EXPECT_FALSE(elsewhere.exact);
  EXPECT_TRUE(elsewhere.named_wrong);
}

TEST(Score, ARivalOfTheFirstCauseIsInItsSetOnly) {
  const Score found = score(hiding("kp_error"),
                            saying("ambiguous", {named("torque_limit", "HeadYaw", {"kp_error"})}));
  EXPECT_FALSE(found.exact);
  EXPECT_FALSE(found.named_wrong);
  EXPECT_TRUE(found.truth_in_set);
  EXPECT_EQ(found.set_size, 2);
}

TEST(Score, ARivalAtAnotherPlaceSaysWhere) {
  const auto sayingRival = [](const std::string& rival) {
    return saying("ambiguous", {named("kp_error", "HeadPitch", {rival})});
  };
  EXPECT_TRUE(score(hiding("kp_error"), sayingRival("kp_error at HeadYaw")).truth_in_set);
  EXPECT_FALSE(score(hiding("kp_error"), sayingRival("kp_error at LElbowYaw")).truth_in_set);
}

TEST(Score, ASecondCauseNamedAloneIsWrongBesideTheTruth) {
  const Score found =
      score(hiding("kp_error"), saying("named", {named("kp_error"), named("backlash")}));
  EXPECT_TRUE(found.exact);
  EXPECT_TRUE(found.named_wrong);
}

TEST(Score, ListedLookAlikesCountAsTheTruth) {
  EXPECT_TRUE(
      score(hiding("sensor_delay", ""), saying("named", {named("command_latency", "")})).exact);
}

TEST(Score, ALookAlikeThatIsListedBeforehandIsAmbiguousNeitherExactNorWrong) {
  Truth truth = hiding("cogging");
  truth.hidden[0].look_alikes = {"cable_spring"};
  const Score found = score(truth, saying("named", {named("cable_spring")}));
  EXPECT_FALSE(found.exact);
  EXPECT_FALSE(found.named_wrong);
  EXPECT_TRUE(found.truth_in_set);
  EXPECT_TRUE(found.ambiguous);
  EXPECT_EQ(found.set_size, 2);
  EXPECT_TRUE(score(truth, saying("named", {named("backlash")})).named_wrong);
}

// "A spring, or gravity" beside what else is hidden tells both, though not by its first names.
TEST(Score, OfAPairRivalsAndListedLookAlikesAreFoundAmongWhatIsTold) {
  Truth truth = hiding("cable_spring");
  truth.kind = Kind::Pair;
  truth.hidden.push_back(hiding("backlash").hidden[0]);
  const auto telling = [&](std::vector<GivenCause> causes) {
    return score(truth, saying("ambiguous", std::move(causes)));
  };
  const Score rival =
      telling({named("gravity_scale", "HeadYaw", {"cable_spring"}), named("backlash")});
  EXPECT_EQ(rival.found, 1);
  EXPECT_EQ(rival.found_among, 2);
  EXPECT_EQ(telling({named("gravity_scale"), named("backlash")}).found_among, 1);
  truth.hidden[0].look_alikes = {"gravity_scale"};
  EXPECT_EQ(telling({named("gravity_scale"), named("backlash")}).found_among, 2);
}

TEST(Score, ADataFaultIsNamedByItsKind) {
  Truth truth;
  truth.kind = Kind::DataFault;
  truth.spoil = Spoil::Negate;
  GivenReport report = saying("data_fault");
  report.faults = readFaults("verdict: data_fault\n  clock (note)  fine\n  swapped  q.A follows\n");
  EXPECT_TRUE(score(truth, report).fault_found);
  EXPECT_FALSE(score(truth, report).fault_named);
  truth.spoil = Spoil::SwapJoints;
  EXPECT_TRUE(score(truth, report).fault_named);
}

TEST(Score, AnythingNamedInANullIsAFalseAlarm) {
  Truth null;
  null.joints = {"HeadYaw"};
  EXPECT_TRUE(score(null, saying("ambiguous", {named("a", "HeadYaw", {"b"})})).false_alarm);
  EXPECT_FALSE(score(null, saying("no_discrepancy")).false_alarm);
}

TEST(Score, AStrangerIsFlaggedUnlessACauseIsNamedAlone) {
  const Truth stranger = hiding("");
  EXPECT_TRUE(score(stranger, saying("unknown")).flagged);
  EXPECT_FALSE(score(stranger, saying("named", {named("kp_error")})).flagged);
  EXPECT_FALSE(score(stranger, saying("partly_explained", {named("kp_error")})).flagged);
  EXPECT_TRUE(score(stranger, saying("partly_explained", {named("a", "HeadYaw", {"b"})})).flagged);
}

TEST(Score, TheRightFeatureMayComeSecondNotThird) {
  Truth stranger = hiding("");
  EXPECT_TRUE(score(stranger, saying("unknown")).signature_right);
  stranger.hidden[0].features = {"v"};
  EXPECT_FALSE(score(stranger, saying("unknown")).signature_right);
}

TEST(Score, AHumIsNoFrictionThatComesAndGoes) {
  Truth stranger = hiding("");
  stranger.hidden[0].features = {"1.7 Hz"};
  GivenReport report = saying("unknown");
  report.joints.front().signature = "sin and cos of 1.7 Hz (60 %)";
  EXPECT_TRUE(score(stranger, report).signature_right);
  report.joints.front().signature = "sgn v with sin and cos of 1.7 Hz (60 %)";
  EXPECT_FALSE(score(stranger, report).signature_right);
}

TEST(Score, ErrorsAreRelativeToTheHiddenDeviation) {
  GivenCause given = named("kp_error");
  given.has_number = true;
  given.parameter = "part";
  given.value = given.deviation = 0.21;
  given.low = 0.19;
  given.high = 0.23;
  const Score found = score(hiding("kp_error"), saying("named", {given}));
  ASSERT_EQ(found.numbers.size(), 1u);
  EXPECT_NEAR(found.numbers[0].error, 0.05, 1e-12);
  EXPECT_TRUE(found.numbers[0].covered);
  EXPECT_TRUE(found.numbers[0].own_law);
}

// A report whose statements say of what kind they are.
std::vector<JudgedStatement> judged(const Truth& truth, GivenReport report) {
  for (GivenCause& cause : report.causes) {
    cause.kind.verdict = cause.rivals.empty() ? "named" : "ambiguous";
  }
  if (report.causes.empty()) report.joints.front().kind.verdict = report.verdict;
  return judgeStatements(truth, report);
}

TEST(JudgedStatements, ACauseIsRightAtItsJointOrAmongItsRivals) {
  const Truth truth = hiding("kp_error");
  EXPECT_TRUE(judged(truth, saying("named", {named("kp_error")})).at(0).right);
  EXPECT_TRUE(judged(truth, saying("named", {named("kp_error", "HeadPitch")})).at(0).wrong);
  EXPECT_TRUE(judged(truth, saying("named", {named("backlash")})).at(0).wrong);
  const auto set = saying("ambiguous", {named("backlash", "HeadYaw", {"kp_error"})});
  EXPECT_TRUE(judged(truth, set).at(0).right);
}

TEST(JudgedStatements, AListedLookAlikeIsNeitherRightNorWrong) {
  Truth truth = hiding("kp_error");
  truth.hidden[0].look_alikes = {"torque_limit"};
  const JudgedStatement one = judged(truth, saying("named", {named("torque_limit")})).at(0);
  EXPECT_FALSE(one.right);
  EXPECT_FALSE(one.wrong);
}

TEST(JudgedStatements, NothingIsRightWhereNothingIsHidden) {
  Truth null = hiding("kp_error");
  null.hidden.clear();
  EXPECT_TRUE(judged(null, saying("no_discrepancy")).at(0).right);
  EXPECT_TRUE(judged(null, saying("unknown")).at(0).wrong);
  EXPECT_TRUE(judged(null, saying("named", {named("kp_error")})).at(0).wrong);
  EXPECT_TRUE(judged(hiding("kp_error"), saying("no_discrepancy")).at(0).wrong);
  EXPECT_TRUE(judged(hiding("kp_error", "HeadPitch"), saying("no_discrepancy")).at(0).right);
}

TEST(JudgedStatements, UnknownIsRightOfAStranger) {
  EXPECT_TRUE(judged(hiding(""), saying("unknown")).at(0).right);
  EXPECT_TRUE(judged(hiding("kp_error"), saying("unknown")).at(0).wrong);
  const auto beside = saying("partly_explained", {named("backlash", "HeadYaw", {"unknown"})});
  EXPECT_TRUE(judged(hiding(""), beside).at(0).right);
  EXPECT_TRUE(judged(hiding(""), saying("named", {named("backlash")})).at(0).wrong);
}

}  // namespace
}  // namespace nao::hidden
