// What coarse steps promise and exact runs do not keep.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/validation/diagnosis/toy_search.h"
#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {
namespace {

using test::quick;
using test::softServo;
using test::ToyLaws;

// A joint whose coarse steps take causes for others than the real ones do.
class Mirage final : public JointSimulator {
 public:
  using Bend = std::function<void(EffectSetting&)>;
  Mirage(const ToyLaws& truth, Bend bend)
      : toy_(truth, 1, test::kToyNoise, 6, 3), coarse_(toy_, std::move(bend)) {}
  std::string joint() const override { return toy_.joint(); }
  const std::vector<JointMotion>& measured() const override { return toy_.measured(); }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override {
    return toy_.run(causes, motion, stream, noise);
  }
  double present(const std::string& effect, const std::string& parameter) const override {
    return toy_.present(effect, parameter);
  }
  const JointSimulator& coarse() const override { return coarse_; }

 private:
  class Coarse final : public JointSimulator {
   public:
    Coarse(const test::ToyJoint& toy, Bend bend) : toy_(toy), bend_(std::move(bend)) {}
    std::string joint() const override { return toy_.joint(); }
    const std::vector<JointMotion>& measured() const override { return toy_.measured(); }
    Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                        std::uint64_t stream, const JointNoise& noise) const override {
      std::vector<EffectSetting> taken = causes;
      for (EffectSetting& cause : taken) bend_(cause);
      return toy_.run(taken, motion, stream, noise);
    }

   private:
    const test::ToyJoint& toy_;
    Bend bend_;
  };

  test::ToyJoint toy_;
  Coarse coarse_;
};

JointVerdict diagnoseBy(const Mirage& mirage, const std::set<std::string>& ids) {
  std::vector<Cause> causes;
  for (const Cause& one : test::toyCauses()) {
    if (ids.count(one.id) > 0) causes.push_back(one);
  }
  Effort effort = quick();
  effort.most_causes = static_cast<int>(ids.size());
  JointSearch search(mirage, test::kToyNoise, causes, effort, 1000000);
  search.begin();
  return search.conclude({});
}

// A weak servo whose coarse steps show a lighter rotor as what is wrong; the real ones do not.
TEST(JointSearch, NamesNothingThatExactRunsDoNotBearOut) {
  const Mirage mirage(softServo(), [](EffectSetting& cause) {
    if (cause.name == "motor_inertia") cause.name = "kp_error";
  });
  const JointVerdict verdict = diagnoseBy(mirage, {"motor_inertia"});
  EXPECT_TRUE(verdict.findings.empty());
  EXPECT_EQ(verdict.verdict, Verdict::Unknown);
  ASSERT_EQ(verdict.rejected.size(), 1u);
  EXPECT_EQ(verdict.rejected[0].reason, "runs without approximations do not bear it out");
}

// A friction that holds the joint for most of the time, and coarse steps that make a fifth less of
// it: told as 1.75 N m beside a remainder (2.3 times what chance leaves). So was a hip's friction
// of 2.24 N m, beside three more causes, in 381 s.
TEST(JointSearch, GoesOnByExactRunsWhereTheyLeaveMoreThanChance) {
  ToyLaws laws;
  laws.stribeck = 1.8;
  laws.stribeck_speed = 0.2;
  const Mirage mirage(laws, [](EffectSetting& cause) {
    if (cause.name == "stribeck_friction") cause.parameters["torque"] *= 0.8;
  });
  const JointVerdict verdict = diagnoseBy(mirage, {"stribeck_friction"});
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  EXPECT_LT(verdict.misfit_after, 1.3);
  ASSERT_EQ(verdict.named().size(), 1u);
  EXPECT_NEAR(verdict.named()[0]->numbers[0].deviation, 1.8, 0.01 * 1.8);
}

// With a hold whose coarse steps tick a ten thousandth late.
Mirage lateTicks(ToyLaws laws) {
  laws.hold = 0.0094;
  laws.sent = 0.01;
  return Mirage(laws, [](EffectSetting& cause) {
    if (cause.name == "command_hold") cause.parameters["interval"] *= 1.0001;
  });
}

// It was told beside a remainder. So was an elbow's of 10.703 ms, as 10.7016, beside a friction and
// late readings.
TEST(JointSearch, MeetsAHoldsBeatByExactRuns) {
  const JointVerdict verdict = diagnoseBy(lateTicks({}), {"command_hold"});
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  ASSERT_EQ(verdict.named().size(), 1u);
  EXPECT_NEAR(verdict.named()[0]->numbers[0].deviation, 0.0094, 3e-7);
}

// Nor were a head's stop and hold of 7.5 ms told: 0.001 ms off it explained nothing by exact runs,
// a friction was taken for it, and what had been found had to go.
TEST(JointSearch, MeetsAHoldsBeatByExactRunsBesideAFirstCauseToo) {
  std::map<std::string, double> told;
  const JointVerdict verdict = diagnoseBy(lateTicks(softServo()), {"kp_error", "command_hold"});
  for (const Finding* one : verdict.named()) told[one->cause] = one->numbers[0].deviation;
  EXPECT_EQ(verdict.verdict, Verdict::Named);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_NEAR(told["command_hold"], 0.0094, 3e-7);
  EXPECT_NEAR(told["kp_error"], -0.3, 0.02);
}

// Coarse steps make a tenth more of it, so that only exact runs show that it is as large as gears
// allow. An elbow's friction of another law was told as that of its load, 0.9, alone.
TEST(JointSearch, NamesNothingAloneThatExactRunsPutAtTheEndOfItsRange) {
  ToyLaws laws;
  laws.load += 0.91;  // the effect goes to 0.9
  const Mirage mirage(laws, [](EffectSetting& cause) {
    if (cause.name == "load_friction") cause.parameters["share"] *= 1.1;
  });
  const JointVerdict verdict = diagnoseBy(mirage, {"load_friction"});
  ASSERT_EQ(verdict.findings.size(), 1u);
  EXPECT_NEAR(verdict.findings[0].numbers[0].deviation, 0.9, 1e-6);
  EXPECT_FALSE(verdict.remains());
  EXPECT_EQ(verdict.verdict, Verdict::Ambiguous);
  ASSERT_EQ(verdict.findings[0].rivals.size(), 1u);
  EXPECT_EQ(verdict.findings[0].rivals[0].cause, "unknown");
}

}  // namespace
}  // namespace nao::validation
