#include "validation/diagnosis/causes/causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "core/config.h"
#include "tests/support/models.h"
#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/causes/cause_list.h"
#include "validation/diagnosis/causes/whole_causes.h"

namespace nao::validation {
namespace {

const Cause& cause(const std::string& id) {
  for (const Cause& one : jointCauses()) {
    if (one.id == id) return one;
  }
  throw InputError(id);
}

TEST(JointCauses, HaveNamesOfTheirOwnAndParametersOfTheirEffect) {
  std::set<std::string> seen;
  for (const Cause& one : jointCauses()) {
    EXPECT_TRUE(seen.insert(one.id).second) << one.id;
    const sim::EffectType* type = sim::standardEffects().find(one.effect);
    ASSERT_NE(type, nullptr) << one.id;
    for (const FreeNumber& number : one.free) {
      EXPECT_TRUE(std::any_of(type->parameters.begin(), type->parameters.end(),
                              [&](const sim::Parameter& p) { return p.name == number.parameter; }))
          << one.id << " " << number.parameter;
      EXPECT_FALSE(number.starts.empty()) << one.id;
    }
    EXPECT_FALSE(showCause(one.id, *nao::test::robot("nao_h21_v33")).empty());
  }
}

TEST(JointCauses, ShrinkWhatTheModelHasByNoMoreThanThereIs) {
  const test::ToyJoint toy({}, 1, test::kToyNoise, 2, 1);
  const Cause friction = boundedAt(cause("coulomb_friction"), toy, sim::standardEffects());
  EXPECT_DOUBLE_EQ(friction.free[0].lower, -test::ToyLaws{}.coulomb);
  EXPECT_NEAR(friction.spread, 0.1 / std::sqrt(3.0) * test::ToyLaws{}.coulomb, 1e-12);
}

TEST(JointCauses, AreLawsToOneOrTwoPerCentUnlessTheySayWhereSomethingEnds) {
  const double error = cause("torque_bias").lawErrorAt(2);
  EXPECT_GT(error, 0.01 * 2);
  EXPECT_LT(error, 0.02 * 2);
  EXPECT_DOUBLE_EQ(cause("torque_bias").lawErrorAt(-2), error);
  EXPECT_EQ(cause("joint_stop.upper").lawErrorAt(-0.3), 0);
  EXPECT_EQ(cause("rate_limit").lawErrorAt(0.2), 0);
}

// Each is looked for where the other was found.
TEST(JointCauses, ThatDoNearlyTheSameKnowOfEachOther) {
  const std::vector<Cause> causes = jointCauses();
  std::set<std::pair<std::string, std::string>> twins;
  for (const Cause& cause : causes) {
    for (const std::string& twin : cause.twins) twins.insert({cause.id, twin});
  }
  EXPECT_EQ(twins.count({"joint_stop.upper", "encoder_offset"}), 1u);
  for (const auto& [one, other] : twins) EXPECT_EQ(twins.count({other, one}), 1u) << one;
}

// A spring that hardens was told as a spring and a ripple of 4 periods per turn, of which the
// joint's range shows nine tenths of one.
TEST(JointCauses, ARippleShowsAWholePeriodAtLeast) {
  const test::ToyJoint toy({}, 1, test::kToyNoise, 2, 1);
  double least = 10, most = -10;  // [rad]
  for (const JointMotion& motion : toy.measured()) {
    for (const Eigen::MatrixXd& run : motion.repeats) {
      if (motion.split == Split::Test) continue;
      least = std::min(least, run.col(0).minCoeff());
      most = std::max(most, run.col(0).maxCoeff());
    }
  }
  const Cause ripple = boundedAt(cause("cogging"), toy, sim::standardEffects());
  ASSERT_FALSE(startsOf(ripple).empty());
  for (const std::vector<double>& x : startsOf(ripple)) {
    const double per_turn = settingOf(ripple, x).parameters.at("per_turn");
    EXPECT_GE(per_turn * (most - least), 2 * M_PI);
  }
}

// But where nothing acts beside it, as a hip's narrow range shows half a period: no look tells it.
TEST(JointCauses, PartOfARippleIsForWhereNothingWasFound) {
  const test::ToyJoint toy({}, 1, test::kToyNoise, 2, 1);
  const std::vector<Cause> all = withPartsOfRipples(jointCauses());
  ASSERT_EQ(all.size(), jointCauses().size() + 1);
  const Cause part = boundedAt(all.back(), toy, sim::standardEffects());
  const Cause whole = boundedAt(cause("cogging"), toy, sim::standardEffects());
  EXPECT_EQ(part.id, whole.id);
  EXPECT_TRUE(part.alone);
  EXPECT_TRUE(startsOf(part).empty());
  EXPECT_EQ(part.free[1].upper, whole.free[1].lower);
  EXPECT_EQ(part.free[1].neutral + part.free[1].lower, 4);  // periods per turn, of the effect
}

// A physics engine of another kind was told as a battery that rises by 0.5 % per second: 1.6 % on
// the mean of six seconds, where a drop of that size would not have been named.
TEST(JointCauses, AskAsMuchOfAVoltageThatSinksAsOfOneThatIsLow) {
  const test::ToyJoint toy({}, 1, test::kToyNoise, 2, 1);
  const FreeNumber drop = boundedAt(cause("voltage_sag.drop"), toy, sim::standardEffects()).free[0];
  const FreeNumber slope =
      boundedAt(cause("voltage_sag.slope"), toy, sim::standardEffects()).free[0];
  const JointMotion& motion = toy.measured().front();
  const double seconds = static_cast<double>(motion.repeats.front().rows()) * motion.dt;
  EXPECT_NEAR(slope.smallest * seconds / 2, drop.smallest, 1e-12);
}

TEST(JointCauses, BecomeSettingsThatDoNothingElse) {
  const EffectSetting low = settingOf(cause("voltage_sag.drop"), {0.2});
  EXPECT_DOUBLE_EQ(low.parameters.at("drop"), 0.2);
  EXPECT_DOUBLE_EQ(low.parameters.at("slope"), 0);
}

TEST(CauseList, HasTheCausesOfEveryLevel) {
  const auto nao = nao::test::robot("nao_h21_v33");
  const auto idsOf = [&](const std::string& level) {
    std::set<std::string> ids;
    for (const ListedCause& one : listCauses(level, *nao)) {
      EXPECT_FALSE(one.places.empty()) << one.cause.id;
      EXPECT_TRUE(ids.insert(one.cause.id).second) << one.cause.id;
    }
    return ids;
  };
  EXPECT_EQ(idsOf("joint").size(), jointCauses().size());
  EXPECT_TRUE(idsOf("robot").count("ground_friction"));
  EXPECT_FALSE(idsOf("joint").count("ground_friction"));
  EXPECT_TRUE(idsOf("limb").count("coupled_stop.upper"));
  EXPECT_NE(showCause("ground_friction", *nao).find("tried on: robot"), std::string::npos);
}

std::set<std::string> withTwoNumbers(const char* level) {
  std::set<std::string> two;
  for (const ListedCause& one : listCauses(level, *nao::test::robot("nao_h21_v33"))) {
    const auto& all = one.cause.free;
    const auto fitted = std::count_if(all.begin(), all.end(),
                                      [](const FreeNumber& number) { return !number.stays; });
    EXPECT_LE(fitted, 2) << one.cause.id;
    if (fitted > 1) two.insert(one.cause.id);
  }
  return two;
}

// Second numbers double what there is to fit. Hanging limbs tell a friction that creeps from one
// that sticks: without, 0.9 N m of it were told as 0.81 and a remainder.
TEST(CauseList, OfLimbsAndRobotsHasFewSecondNumbers) {
  EXPECT_EQ(withTwoNumbers("limb"),
            (std::set<std::string>{"coulomb_friction", "coupled_stop.lower", "coupled_stop.upper",
                                   "servo_deadband"}));
  EXPECT_EQ(
      withTwoNumbers("robot"),
      (std::set<std::string>{"coulomb_friction", "coupled_stop.lower", "coupled_stop.upper"}));
}

// An ankle that was left with 0.087 of its torque was no candidate: at 0.4 hardly anything shows.
TEST(WholeCauses, LookAtLegJointsWithLittleTorque) {
  const auto nao = nao::test::robot("nao_h21_v33");
  std::vector<Joint> legs;
  for (const char* name : {"LAnklePitch", "RAnklePitch"}) legs.push_back(*nao->findJoint(name));
  int judged = 0;
  for (const PlacedCause& one : robotCauses(*nao, legs)) {
    if (one.cause.id != "torque_limit" || one.place == "robot") continue;
    const std::vector<double>& starts = one.cause.free[0].starts;
    EXPECT_LE(*std::min_element(starts.begin(), starts.end()), -0.8) << one.place;
    ++judged;
  }
  EXPECT_GE(judged, 2);
}

// A standing knee's gain less by 0.68 was told as a dead band, those of a walking leg less by 0.16
// were not seen: in the play of a gear a little more gain shows nothing, and a loss is no multiple
// of it.
TEST(RobotCauses, GainsAreLookedAtByALossToo) {
  const auto nao = nao::test::robot("nao_h21_v33");
  std::vector<Joint> legs;
  for (const char* name : {"LKneePitch", "LAnklePitch", "RKneePitch", "RAnklePitch"}) {
    legs.push_back(*nao->findJoint(name));
  }
  std::map<std::string, double> least;  // by place
  for (const PlacedCause& one : robotCauses(*nao, legs)) {
    if (one.cause.id != "kp_error") continue;
    const std::vector<double>& starts = one.cause.free[0].starts;
    least[one.place] = *std::min_element(starts.begin(), starts.end());
    EXPECT_TRUE(one.cause.gross) << one.place;
  }
  ASSERT_EQ(least.size(), 7u);  // the robot, two sides, four joints
  for (const auto& [place, start] : least) {
    EXPECT_LE(start, nao->findJoint(place) ? -0.5 : -0.25) << place;
  }
}

// An ankle's zero, of a walk, was told as the hip's that turns alike: where that fitted well, the
// ankle's was not tried, as by looks of other sizes it promised a tenth of it.
TEST(RobotCauses, ZerosOfALegThatTurnAlikeAreTwins) {
  const auto nao = nao::test::robot("nao_h21_v33");
  std::vector<Joint> all;
  for (const Actuator& one : nao->actuators) all.push_back(*nao->findJoint(one.name));
  std::map<std::string, std::vector<std::string>> twins;  // by place
  for (const PlacedCause& one : robotCauses(*nao, all)) {
    if (one.cause.id == "encoder_offset") twins[one.place] = one.twins;
  }
  EXPECT_THAT(twins.at("RHipRoll"), testing::ElementsAre("RAnkleRoll"));
  EXPECT_THAT(twins.at("LKneePitch"), testing::ElementsAre("LHipPitch", "LAnklePitch"));
  EXPECT_TRUE(twins.at("LElbowRoll").empty());
}

// Smooth friction of all joints, 0.3 N m, was told as 0.24 that sticks and the gains of both
// elbows.
TEST(RobotCauses, FrictionOfAllJointsMayCreep) {
  const auto nao = nao::test::robot("nao_h21_v33");
  std::map<std::string, std::size_t> numbers;  // by place
  for (const PlacedCause& one : robotCauses(*nao, {*nao->findJoint("LKneePitch")})) {
    if (one.cause.id == "coulomb_friction") numbers[one.place] = one.cause.free.size();
  }
  EXPECT_EQ(numbers.at("robot"), 2u);
  EXPECT_EQ(numbers.at("LKneePitch"), 1u);
}

TEST(CauseList, IsJsonToo) {
  const auto list = nlohmann::json::parse(toJson(listCauses("joint", *nao::test::robot("arm"))));
  ASSERT_EQ(list.size(), jointCauses().size());
  for (const auto& one : list) {
    EXPECT_FALSE(one.at("numbers").empty()) << one.at("id");
    EXPECT_LT(one.at("numbers")[0].at("min"), one.at("numbers")[0].at("max"));
  }
}

TEST(CauseList, SaysWhatItDoesNotKnow) {
  const auto nao = nao::test::robot("nao_h21_v33");
  EXPECT_THROW(showCause("gremlins", *nao), InputError);
  EXPECT_THROW(listCauses("toe", *nao), InputError);
}

}  // namespace
}  // namespace nao::validation
