#include "validation/diagnosis/whole/whole_data.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"
#include "validation/log/floor_recording.h"

namespace nao::validation {
namespace {

// A squat, free of noise: what coarse runs are off by is no chance.
class Squat : public testing::Test {
 protected:
  LogSet record() const {
    FloorPlan plan;
    plan.model = model_;
    plan.motions = {{"squat", Split::Fit, 1.5, {}}};
    plan.repeats = 1;
    return recordOnFloor(plan);
  }

  // RMS, in floors of the features, of what coarse runs are off by.
  double coarseRunsAreOffBy(const std::vector<EffectSetting>& causes) const {
    constexpr std::uint64_t kStreams = 4;  // those of step errors: a robot starts as in these
    const Eigen::VectorXd exact = data_.spaces()[0].of(
        simulator_.simulate(causes, 0, (kStreams << 40) + 1, kNoNoise, Pace::Exact));
    const WholePool coarse = data_.simulate(causes, 1, 1, Blocks::All, kStreams, kNoNoise, 1);
    Eigen::VectorXd off = coarse[0][0] - exact;
    for (const FeatureGroup& group : data_.spaces()[0].groups()) {
      off.segment(group.offset, group.size) /= group.floor;
    }
    return off.norm() / std::sqrt(static_cast<double>(off.size()));
  }

  void learnWith(const std::vector<EffectSetting>& causes) {
    data_.learnStepErrors(causes, 1, kNoNoise, 1);
  }

  const NoiseParts kNoNoise{0, 0};
  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  WholeSimulator simulator_{record(), model_};
  WholeData data_{simulator_, simulator_.judged(), true};
};

TEST_F(Squat, StepErrorsAreThoseOfTheCausesTheyWereLearnedWith) {
  // One and a half coarse steps.
  const std::vector<EffectSetting> late{{"command_latency", {{"delay", 0.003}}, {}, ""}};
  const double unknown = coarseRunsAreOffBy(late);
  learnWith({});
  EXPECT_LT(coarseRunsAreOffBy({}), 1e-9);
  const double of_the_model = coarseRunsAreOffBy(late);
  learnWith(late);
  EXPECT_LT(coarseRunsAreOffBy(late), 1e-9);
  EXPECT_GT(of_the_model, 0.5 * unknown);  // so that there is something to learn anew
}

}  // namespace
}  // namespace nao::validation
