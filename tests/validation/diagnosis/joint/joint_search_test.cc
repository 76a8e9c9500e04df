#include "validation/diagnosis/joint/joint_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "tests/validation/diagnosis/toy_search.h"

namespace nao::validation {
namespace {

using test::diagnose;
using test::quick;
using test::softServo;
using test::ToyLaws;
using test::without;

ToyLaws deadServo() {
  ToyLaws laws;
  laws.deadband = 0.012;
  return laws;
}

TEST(JointSearch, NamesNothingWhereNothingIsWrong) {
  const JointVerdict verdict = diagnose({}, test::toyCauses());
  EXPECT_EQ(verdict.verdict, Verdict::NoDiscrepancy);
  // Null sets allow for a model that mispredicts an encoder's rounding; the toy's does not.
  EXPECT_LT(verdict.misfit_before, 1.15);
  EXPECT_GT(verdict.misfit_before, 0.7);
}

// A weak servo where gains are of interest from so far on: 0 as its number says, 1 as the end of
// its interval says.
JointVerdict diagnoseWithInterest(double way) {
  const FoundNumber weak = diagnose(softServo(), test::toyCauses()).findings.at(0).numbers[0];
  std::vector<Cause> causes = test::toyCauses();
  for (Cause& cause : causes) {
    if (cause.id != "kp_error") continue;
    cause.free[0].smallest = -((1 - way) * weak.deviation + way * weak.high);
  }
  return diagnose(softServo(), causes);
}

// An engine of another kind was told as a battery 3 % too full, where 2 % are of interest and the
// interval reached down to 1.8 %.
TEST(JointSearch, NamesNothingThatMayBeTooSmallToMatter) {
  const JointVerdict verdict = diagnoseWithInterest(0.3);
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_TRUE(verdict.findings[0].small);
  EXPECT_EQ(verdict.verdict, Verdict::NoDiscrepancy);
}

// A drag of 0.0075 N m s/rad at an ankle, where 0.005 are of interest and the interval reached down
// to 0.0046.
TEST(JointSearch, NamesWhatIsOfInterestByNineChancesOfTen) {
  EXPECT_EQ(diagnoseWithInterest(0.88).verdict, Verdict::Named);
}

// How much a joint sticks and up to which speed undo each other; a gain has no shape.
TEST(JointSearch, TellsTheSizeOfALoneCauseAlsoWithTheShapeThatItHas) {
  EXPECT_TRUE(diagnose(softServo(), test::toyCauses()).findings.at(0).as_shaped.empty());
  ToyLaws laws;
  laws.stribeck = 0.4;
  const Finding sticks = diagnose(laws, test::toyCauses()).findings.at(0);
  ASSERT_EQ(sticks.cause, "stribeck_friction");
  ASSERT_EQ(sticks.as_shaped.size(), 1u);
  EXPECT_EQ(sticks.as_shaped[0].deviation, sticks.numbers[0].deviation);
  EXPECT_LT(sticks.as_shaped[0].high - sticks.as_shaped[0].low,
            0.95 * (sticks.numbers[0].high - sticks.numbers[0].low));
}

TEST(JointSearch, NamesAWeakServoAndHowWeakItIs) {
  const JointVerdict verdict = diagnose(softServo(), test::toyCauses());
  ASSERT_FALSE(verdict.named().empty());
  EXPECT_EQ(verdict.named()[0]->cause, "kp_error");
  EXPECT_EQ(verdict.named().size(), 1u);
  EXPECT_NEAR(verdict.findings[0].numbers[0].deviation, -0.3, 0.02);
  EXPECT_LE(verdict.findings[0].numbers[0].low, -0.3);
  EXPECT_GE(verdict.findings[0].numbers[0].high, -0.3);
  EXPECT_LT(verdict.misfit_after, 1.15);
}

// 0.08 degree of zero and 1.5 % of gain: robots of one kind differ by that, so that it is no cause.
TEST(JointSearch, TellsWhatARobotDiffersByWithoutNamingIt) {
  ToyLaws laws;
  laws.zero = 1.4e-3;
  laws.kd *= 1.015;
  laws.deadband = 0.012;
  const JointVerdict verdict = diagnose(laws, test::toyCauses());
  ASSERT_EQ(verdict.verdict, Verdict::Named);
  EXPECT_EQ(verdict.findings[0].cause, "servo_deadband");
  std::map<std::string, FoundNumber> told;
  for (const Adjustment& one : verdict.adjustments) told[one.cause] = one.number;
  EXPECT_EQ(told.count("servo_deadband"), 0u);
  for (const auto& [cause, truth] : std::map<std::string, double>{
           {"encoder_offset", 1.4e-3}, {"kd_error", 0.015}, {"kp_error", 0}}) {
    ASSERT_EQ(told.count(cause), 1u) << cause;
    EXPECT_GE(truth, told[cause].low) << cause;
    EXPECT_LE(truth, told[cause].high) << cause;
  }
  EXPECT_GT(told["encoder_offset"].deviation, 0.7e-3);
}

// What is left beside a gross cause is as likely that cause's own law, which is not quite the
// catalogue's: a bias that is named alone is not beside 27,000 nats, although 24 speak for it.
TEST(JointSearch, NamesNothingBesideACauseThatExplainsHundredsOfTimesAsMuch) {
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws;
  laws.bias = 0.012;
  EXPECT_EQ(diagnose(laws, test::toyCauses(), two).named().size(), 1u);
  laws.zero = 0.25;
  laws.bias = 0.008;
  const JointVerdict beside = diagnose(laws, test::toyCauses(), two);
  ASSERT_EQ(beside.named().size(), 1u);
  EXPECT_EQ(beside.named()[0]->cause, "encoder_offset");
}

// But of what another law leaves no second cause is the whole.
TEST(JointSearch, NamesASmallSecondCauseThatLeavesNothing) {
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws;
  laws.zero = 0.25;
  laws.viscous += 0.06;  // explains 0.5 % as much
  const JointVerdict all = diagnose(laws, test::toyCauses(), two);
  EXPECT_EQ(all.verdict, Verdict::Named);
  ASSERT_EQ(all.named().size(), 2u);
  EXPECT_EQ(all.named()[1]->cause, "viscous_friction");
  const FoundNumber& damping = all.named()[1]->numbers[0];
  EXPECT_LE(damping.low, 0.06);
  EXPECT_GE(damping.high, 0.06);
  laws.cogging = 0.03;
  const JointVerdict part = diagnose(laws, test::toyCauses(), two);
  EXPECT_EQ(part.verdict, Verdict::PartlyExplained);
  EXPECT_EQ(part.findings.size(), 1u);
}

// Nor beside a gross cause that all joints share, which is given.
TEST(JointSearch, NamesNothingBesideAGivenCauseThatExplainsHundredsOfTimesAsMuch) {
  ToyLaws laws;
  laws.bias = 0.008;
  laws.zero = 0.25;
  const std::vector<Cause> causes = test::toyCauses();
  const auto zero = std::find_if(causes.begin(), causes.end(),
                                 [](const Cause& one) { return one.id == "encoder_offset"; });
  const test::ToyJoint toy(laws, 1, test::kToyNoise, 6, 3);
  JointSearch search(toy, test::kToyNoise, causes, quick(), 1000000);
  search.begin();
  search.give(static_cast<std::size_t>(zero - causes.begin()), laws.zero);
  EXPECT_TRUE(search.conclude({}).named().empty());
}

// Beside a dry friction that explains 40 times as much a damping is as likely the first one's own
// law, and so is what else would explain some of that.
TEST(JointSearch, NamesNoSecondLawOfAFamilyThatTheFirstMayOnlyBeLike) {
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws;
  laws.coulomb += 0.6;
  laws.viscous += 0.2;
  std::vector<Cause> causes = test::toyCauses();
  const JointVerdict verdict = diagnose(laws, causes, two);
  EXPECT_EQ(verdict.verdict, Verdict::PartlyExplained);
  ASSERT_EQ(verdict.named().size(), 1u);
  EXPECT_EQ(verdict.named()[0]->cause, "coulomb_friction");
  for (Cause& cause : causes) cause.family.clear();
  EXPECT_EQ(diagnose(laws, causes, two).named().size(), 2u);
}

// A tilt (3 % of what the offset explains) and a mass (1.9 %). If a tilt of that size is of no
// interest, the mass is of none.
TEST(JointSearch, SearchesNoFurtherThanATrifle) {
  Effort four = quick();
  four.most_causes = 4;
  ToyLaws laws;
  laws.zero = 0.15;
  laws.bias = 0.032;
  laws.mass *= 1.25;
  std::vector<Cause> causes = test::toyCauses();
  EXPECT_EQ(diagnose(laws, causes, four).findings.size(), 3u);
  for (Cause& cause : causes) {
    if (cause.id == "ground_tilt.y") cause.free[0].smallest = 0.05;
  }
  const JointVerdict verdict = diagnose(laws, causes, four);
  ASSERT_EQ(verdict.findings.size(), 2u);
  EXPECT_TRUE(verdict.findings[1].small);
}

// A head's gain that grew was told as a higher one, alone, beside a hold of no interest of 5.003
// ms, whose beat with the commands grows, too.
TEST(JointSearch, WhatLeansOnACauseOfNoInterestIsNotAll) {
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws = softServo();
  laws.latency += 0.01;
  std::vector<Cause> causes = test::toyCauses();
  const auto late = std::find_if(causes.begin(), causes.end(),
                                 [](const Cause& one) { return one.id == "command_latency"; });
  late->free[0].smallest = 0.02;
  const JointVerdict leaning = diagnose(laws, causes, two);
  EXPECT_EQ(leaning.verdict, Verdict::PartlyExplained);
  ASSERT_EQ(leaning.named().size(), 1u);
  ASSERT_EQ(leaning.named()[0]->rivals.size(), 1u);
  EXPECT_EQ(leaning.named()[0]->rivals[0].cause, "unknown");
  late->spread = 0.005;  // equal robots differ by it
  EXPECT_EQ(diagnose(laws, causes, two).verdict, Verdict::Named);
}

// Friction near an angle and friction near a speed: a tenth of it by a friction, a tenth of the
// rest by a dead band, and so on.
TEST(JointSearch, GivesUpWhereTwoCausesExplainLittle) {
  Effort four = quick();
  four.most_causes = 4;
  ToyLaws laws;
  laws.spot = 0.5;
  laws.band = 0.4;
  const JointVerdict verdict = diagnose(laws, test::toyCauses(), four);
  EXPECT_EQ(verdict.verdict, Verdict::PartlyExplained);
  EXPECT_EQ(verdict.findings.size(), 2u);
}

// A duty that grows with the root of its error alone was told as unknown: there is no more of it.
TEST(JointSearch, APartThatIsAllIsNamedAtTheEndOfItsRange) {
  std::vector<Cause> causes;
  for (const Cause& cause : test::toyCauses()) {
    if (cause.id == "load_friction") causes.push_back(cause);
  }
  causes[0].free.resize(1);
  ToyLaws laws;
  laws.load += 0.95;  // the effect goes to 0.9
  EXPECT_TRUE(diagnose(laws, causes).findings.empty());
  causes[0].whole = true;
  const JointVerdict verdict = diagnose(laws, causes);
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_NEAR(verdict.findings[0].numbers[0].deviation, 0.9, 1e-6);
}

// Alone the friction of the load would have to do the other's work, too, beyond what gears can
// lose.
TEST(JointSearch, ACauseAtTheEndOfItsRangeIsNamedIfASecondOneFreesIt) {
  const std::map<std::string, double> truth{{"load_friction", 0.85}, {"coulomb_friction", 0.1}};
  ToyLaws laws;
  laws.load += truth.at("load_friction");
  laws.coulomb += truth.at("coulomb_friction");
  std::vector<Cause> causes;
  for (const Cause& cause : test::toyCauses()) {
    if (truth.count(cause.id) > 0) causes.push_back(cause);
  }
  const auto rejected = [](const JointVerdict& verdict) {
    return std::any_of(verdict.rejected.begin(), verdict.rejected.end(), [](const Rejected& one) {
      return one.cause == "load_friction" && one.reason == "fits best at the end of its range";
    });
  };
  EXPECT_TRUE(rejected(diagnose(laws, causes)));
  Effort two = quick();
  two.most_causes = 2;
  const JointVerdict both = diagnose(laws, causes, two);
  EXPECT_FALSE(rejected(both));
  EXPECT_EQ(both.verdict, Verdict::Named);
  ASSERT_EQ(both.findings.size(), 2u);
  for (const Finding& one : both.findings) {
    EXPECT_NEAR(one.numbers[0].deviation, truth.at(one.cause), 0.012) << one.cause;  // 1 % found
  }
}

// A cable that pulls back explains more gravity so well that a bias beside it was told as a
// remainder.
TEST(JointSearch, FindsTwoThatTwoOthersImitate) {
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    for (const char* id : {"torque_bias", "cable_spring", "gravity_scale", "encoder_offset"}) {
      if (cause.id == id) causes.push_back(cause);
    }
  }
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws;
  laws.gravity *= 3;
  laws.bias = 0.3;
  const JointVerdict verdict = diagnose(laws, causes, two);
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  std::map<std::string, double> found;
  for (const Finding& one : verdict.findings) found[one.cause] = one.numbers[0].deviation;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found["gravity_scale"], 2, 0.04);
  EXPECT_NEAR(found["torque_bias"], 0.3, 0.01);
}

// Looks are at up to 24 periods per turn; the torque that the model lacks has others.
TEST(JointSearch, FindsARippleByTheTorqueThatItsModelLacks) {
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    for (const char* id : {"torque_bias", "cable_spring", "kp_error", "cogging"}) {
      if (cause.id == id) causes.push_back(cause);
    }
  }
  ToyLaws laws;
  laws.cogging = 0.6;
  laws.cogs = 31;
  laws.cog_phase = 0.7;
  const JointVerdict verdict = diagnose(laws, causes);
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_EQ(verdict.findings[0].cause, "cogging");
  const std::vector<FoundNumber>& numbers = verdict.findings[0].numbers;
  // By each of them alone the torque is off by 5 % of its height at most, over a radian.
  EXPECT_NEAR(numbers[0].value, laws.cogging, 0.05 * laws.cogging);
  EXPECT_NEAR(numbers[1].value, laws.cogs, 0.05);
  EXPECT_NEAR(numbers[2].value, laws.cog_phase, 0.05);
}

// What is smoothed is found first and would act first; limited before it has other corners.
TEST(JointSearch, TellsInWhichOrderACommandIsSmoothedAndLimited) {
  std::vector<Cause> causes;
  for (const Cause& cause : test::toyCauses()) {
    for (const char* id : {"command_filter", "rate_limit", "kd_error"}) {
      if (cause.id == id) causes.push_back(cause);
    }
  }
  Effort two = quick();
  two.most_causes = 2;
  ToyLaws laws;
  laws.filter = 0.04;
  laws.rate = 2;
  const JointVerdict verdict = diagnose(laws, causes, two);
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  ASSERT_EQ(verdict.findings.size(), 2u);
  EXPECT_EQ(verdict.findings[0].cause, "rate_limit");
  EXPECT_NEAR(verdict.findings[0].numbers[0].deviation, 0.5, 0.01);
  EXPECT_EQ(verdict.findings[1].cause, "command_filter");
  EXPECT_NEAR(verdict.findings[1].numbers[0].deviation, 0.04, 8e-4);
}

TEST(JointSearch, AdjustsNothingBesideWhatHasNoName) {
  EXPECT_TRUE(diagnose(deadServo(), without({"servo_deadband"})).adjustments.empty());
}

TEST(JointSearch, SaysUnknownOfACauseThatIsNotInItsCatalogue) {
  const JointVerdict verdict = diagnose(deadServo(), without({"servo_deadband"}));
  EXPECT_TRUE(verdict.verdict == Verdict::Unknown || verdict.verdict == Verdict::PartlyExplained)
      << wordOf(verdict.verdict);
}

// A knee with another friction: 303 nats were told as below a threshold of 11.
TEST(JointSearch, GivesEachCauseAReasonThatItsGainBearsOut) {
  Effort effort = quick();
  effort.finalists = 1;
  const JointVerdict verdict = diagnose(deadServo(), without({"servo_deadband"}), effort);
  const std::string below = "its gain is below the threshold";
  ASSERT_FALSE(verdict.rejected.empty());
  for (const Rejected& one : verdict.rejected) {
    EXPECT_TRUE(one.reason != below || one.gain <= verdict.critical_gain) << one.cause;
  }
}

TEST(JointSearch, SaysAmbiguousOfACauseThatIsInItsCatalogueTwice) {
  std::vector<Cause> causes = test::toyCauses();
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (causes[i].id != "servo_deadband") continue;
    Cause twin = causes[i];
    twin.id = "its_twin";
    causes.push_back(twin);
    break;
  }
  const JointVerdict verdict = diagnose(deadServo(), causes);
  EXPECT_EQ(verdict.verdict, Verdict::Ambiguous);
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_EQ(verdict.findings[0].rivals.size(), 1u);
}

TEST(JointSearch, SaysUnfinishedOutOfBudgetNeverUnknown) {
  const JointVerdict verdict = diagnose(deadServo(), test::toyCauses(), quick(), 1500);
  EXPECT_EQ(verdict.verdict, Verdict::Unfinished);
  EXPECT_FALSE(verdict.not_tried.empty());
}

TEST(JointSearch, LooksAtNothingThatTheBudgetDoesNotPayFor) {
  const JointVerdict verdict = diagnose(deadServo(), test::toyCauses(), quick(), 100);
  EXPECT_EQ(verdict.verdict, Verdict::Unfinished);
  EXPECT_EQ(verdict.not_tried.size(), test::toyCauses().size());
  EXPECT_TRUE(verdict.findings.empty());
}

}  // namespace
}  // namespace nao::validation
