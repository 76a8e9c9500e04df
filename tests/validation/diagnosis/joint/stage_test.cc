#include "validation/diagnosis/joint/stage.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"

namespace nao::validation {
namespace {

constexpr std::size_t kGain = 0, kBias = 1, kDelay = 2;

// A toy whose servo is weak, and three causes of it.
class StageTest : public ::testing::Test {
 protected:
  StageTest() {
    for (const char* id : {"kp_error", "torque_bias", "command_latency"}) {
      for (const Cause& cause : jointCauses()) {
        if (cause.id == id) causes_.push_back(boundedAt(cause, toy_, sim::standardEffects()));
      }
    }
    effort_.base_runs = 8;
    effort_.look_runs = 2;
  }

  static test::ToyLaws weak() {
    test::ToyLaws laws;
    laws.kp *= 0.7;
    return laws;
  }

  Stage stageOf(const CauseList& model) {
    const auto numbers = static_cast<Eigen::Index>(model.size());
    return {ensemble_, data_, causes_, model, Eigen::MatrixXd::Ones(data_.size(), numbers),
            effort_};
  }

  static std::set<std::size_t> seenBy(const Stage& stage) {
    std::set<std::size_t> causes;
    for (const Look& look : stage.looks()) causes.insert(look.cause);
    return causes;
  }

  test::ToyJoint toy_{weak(), 1, test::kToyNoise, 6, 3};
  std::vector<Cause> causes_;
  Effort effort_;
  JointData data_{toy_, test::kToyNoise};
  Ensemble ensemble_{toy_, data_, test::kToyNoise, 1000000};
};

TEST_F(StageTest, LooksAtEveryCauseThatItsModelHasNot) {
  Stage stage = stageOf({{kGain, {-0.3}}});
  EXPECT_TRUE(stage.looks().empty());
  stage.lookAround();
  EXPECT_EQ(seenBy(stage), (std::set<std::size_t>{kBias, kDelay}));
}

TEST_F(StageTest, TakesWithoutARunWhatAnEarlierOneSaw) {
  Stage nominal = stageOf({});
  nominal.lookAround();
  Stage stage = stageOf({{kGain, {-0.3}}});
  const long runs = ensemble_.used();
  stage.lookAround(&nominal);
  EXPECT_EQ(ensemble_.used(), runs);
  ASSERT_EQ(seenBy(stage), (std::set<std::size_t>{kBias, kDelay}));
  for (const Look& look : stage.looks()) {
    const auto same = std::find_if(
        nominal.looks().begin(), nominal.looks().end(),
        [&](const Look& other) { return other.cause == look.cause && other.x == look.x; });
    ASSERT_NE(same, nominal.looks().end());
    EXPECT_EQ(look.raw.first, same->raw.first);
    EXPECT_EQ(look.white.first, stage.white(look.raw).first);  // as this model's numbers leave it
    EXPECT_NE(look.white.first, same->white.first);
  }
}

TEST_F(StageTest, LooksAtWhatAnEarlierOneHadInItsModel) {
  Stage with = stageOf({{kGain, {-0.3}}});
  with.lookAround();
  Stage without = stageOf({});
  const long runs = ensemble_.used();
  without.lookAround(&with);
  EXPECT_GT(ensemble_.used(), runs);
  EXPECT_EQ(seenBy(without), (std::set<std::size_t>{kGain, kBias, kDelay}));
}

}  // namespace
}  // namespace nao::validation
