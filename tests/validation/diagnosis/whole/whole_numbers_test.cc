#include "validation/diagnosis/whole/whole_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/models.h"
#include "validation/log/floor_recording.h"

namespace nao::validation {
namespace {

constexpr double kTruth = -0.4;

// Ten squats of a robot whose left hip pitch has a weak servo, and its one cause.
class WholeNumbersTest : public testing::Test {
 protected:
  WholeNumbersTest() {
    const auto& all = jointCauses();
    const auto kp =
        std::find_if(all.begin(), all.end(), [](const Cause& c) { return c.id == "kp_error"; });
    causes_ = {placedCause(*kp, "LHipPitch", {hip_}, *model_, simulator_.joints())};
    task_.effort.base_runs = 10;
    task_.effort.fit_runs = 5;
  }

  LogSet record() const {
    FloorPlan plan;
    plan.model = model_;
    plan.motions = {{"squat", Split::Fit, 1.5, {}}};
    plan.repeats = 10;
    plan.extra = {{"kp_error", {{"part", kTruth}}, {hip_}, ""}};
    return recordOnFloor(plan);
  }

  // With what coarse runs are off by there, as a search has it.
  WholeFit fitAt(double x) const {
    WholeFit fit;
    fit.model = {{0, {x}}};
    learnStepErrors(task_, fit.model);
    addJacobian(task_, fit);
    return fit;
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  Joint hip_ = *model_->findJoint("LHipPitch");
  WholeSimulator simulator_{record(), model_};
  WholeData data_{simulator_, simulator_.judged(), false};
  std::vector<PlacedCause> causes_;
  WholeTask task_{&data_, &causes_, {}, 1, 1};
};

double varianceOf(const Eigen::MatrixXd& draws) {
  return (draws.array() - draws.mean()).square().mean();
}

// Ten squats tell the number to 0.012: the bound is twice that and more. A jacobian of numbers so
// close that chance parts their runs stops 0.04 short of it.
TEST_F(WholeNumbersTest, AreWhereTheManyRunsOfTheModelFitBest) {
  for (const double off : {-0.03, 0.05}) {
    WholeFit fit = fitAt(kTruth + off);
    const WholeStage stage(task_, fit.model, fit.jacobian);
    refine(task_, stage, fit);
    EXPECT_NEAR(fit.model[0].x[0], kTruth, 0.027) << off;
  }
}

TEST_F(WholeNumbersTest, AreNotMovedFurtherThanChanceGoes) {
  WholeFit fit = fitAt(0.8);
  const WholeStage stage(task_, fit.model, fit.jacobian);
  refine(task_, stage, fit);
  EXPECT_EQ(fit.model[0].x[0], 0.8);
}

// From where few runs left it by chance; a fifth of the way is granted to what bends on it.
TEST_F(WholeNumbersTest, AreAskedToWhereTheyAreFromFurtherThanChanceGoes) {
  const WholeFit fit = fitAt(kTruth + 0.2);
  const WholeStage stage(task_, fit.model, fit.jacobian);
  const WholeStep step = stepOf(task_, stage, fit);
  EXPECT_GT(step.length, kByChance);
  EXPECT_NEAR(step.to[0].x[0], kTruth, 0.04);
  EXPECT_LT(stage.whitenFit(manyRunsResidual(task_, step.to)).norm(),
            stage.whitenFit(stage.raw()).norm());
}

// Chance beside the numbers, by which more is left after the step than before it.
TEST_F(WholeNumbersTest, OnTheFeetGoWhereTheyAreAskedThoughRunsPartByChance) {
  const WholeFit fit = fitAt(kTruth + 0.1);
  const WholeStage stage(task_, fit.model, fit.jacobian);
  const auto square = [&](const Eigen::VectorXd& raw) {
    return stage.whitenFit(raw).squaredNorm();
  };
  const Eigen::VectorXd there = manyRunsResidual(task_, stepOf(task_, stage, fit).to);
  Eigen::VectorXd chance = Eigen::VectorXd::Zero(there.size());
  for (const Eigen::VectorXd& null : stage.nulls()) {
    if (square(there + chance) > square(stage.raw())) break;
    chance += 0.1 * null;
  }
  ASSERT_GT(square(there + chance), square(stage.raw()));
  EXPECT_TRUE(speaksFor(task_, stage, stage.raw(), there + chance));
  EXPECT_FALSE(speaksFor(task_, stage, stage.raw(), stage.raw() + chance));
}

TEST_F(WholeNumbersTest, MayBeOffByWhatEqualRobotsDifferBy) {
  const WholeFit fit = fitAt(kTruth);
  causes_[0].cause.spread = 0;
  const WholeStage stage(task_, fit.model, fit.jacobian);
  const double chance = varianceOf(drawNumbers(task_, stage, fit));
  EXPECT_GT(chance, 0);
  causes_[0].cause.spread = 0.5;
  const double spread = causes_[0].cause.spreadAt(kTruth);
  // 200 draws: a variance is known to a tenth, thrice that is allowed.
  EXPECT_NEAR(varianceOf(drawNumbers(task_, stage, fit)) / (chance + spread * spread), 1, 0.3);
}

// As how steep a stop is and where it begins, of which the sum alone shows.
TEST_F(WholeNumbersTest, ThatUndoEachOtherAreKnownWhereTheOtherStays) {
  WholeFit fit = fitAt(kTruth);
  const WholeStage stage(task_, fit.model, fit.jacobian);
  const WholeFit lone = fit;
  const double size = fit.jacobian.norm();
  fit.model[0].x.push_back(0);
  fit.jacobian.conservativeResize(Eigen::NoChange, 2);
  fit.jacobian.col(1) = fit.jacobian.col(0) + 0.1 * size * stage.nulls()[0].normalized();
  fit.chance.conservativeResize(Eigen::NoChange, 2);
  fit.chance.col(1).setZero();
  const ModelSlopes alone = sizeOf(fit, 0);
  EXPECT_EQ(drawNumbers(task_, stage, alone), drawNumbers(task_, stage, lone));
  EXPECT_GT(varianceOf(drawNumbers(task_, stage, fit).row(0)),
            4 * varianceOf(drawNumbers(task_, stage, alone)));
}

// 200 draws of a normal distribution tell its SD to a twentieth; what signals disagree by beside it
// makes less of it.
TEST_F(WholeNumbersTest, MayBeOffByWhatLawsLeaveOut) {
  const WholeFit fit = fitAt(kTruth);
  const WholeStage stage(task_, fit.model, fit.jacobian);
  const Eigen::MatrixXd with = drawNumbers(task_, stage, fit);
  const double law = causes_[0].cause.lawErrorAt(kTruth);
  ASSERT_GT(law, 0);
  causes_[0].cause.free[0].form = Form::Inverse;  // a limit's, which is read off
  const Eigen::MatrixXd change = with - drawNumbers(task_, stage, fit);
  const double rms = change.norm() / std::sqrt(static_cast<double>(change.size()));
  EXPECT_GT(rms, 0);
  EXPECT_LT(rms, 1.15 * law);
}

}  // namespace
}  // namespace nao::validation
