#include "validation/diagnosis/joint/number_moves.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

// The friction of 1.5 N m of an elbow had an interval from -0.26 to 3.9, as its speed followed:
// nothing was named.
TEST(Reestimated, SizesAreSureWithTheShapeThatUndoesThem) {
  const test::ToyJoint toy({}, 1, test::kToyNoise, 6, 3);
  const JointData data(toy, test::kToyNoise);
  Ensemble ensemble(toy, data, test::kToyNoise, 100000);
  Stage stage(ensemble, data, {}, {}, Eigen::MatrixXd(data.size(), 0), {});
  stage.simulateNulls(toy.joint());
  ModelFit fit;
  fit.model = {{0, {1.5, 0.02}}};
  const Eigen::ArrayXd t = Eigen::ArrayXd::LinSpaced(data.size(), 0, 60);
  fit.jacobian.resize(data.size(), 2);
  fit.jacobian.col(0) = t.sin().matrix();
  fit.jacobian.col(1) = (t.sin() + 0.1 * (3 * t).sin()).matrix();
  fit.chance = Eigen::MatrixXd::Zero(data.size(), 2);
  const double beside = reestimated(stage, fit).col(0).norm();
  const double alone = reestimated(stage, sizeOf(fit, 0)).col(0).norm();
  EXPECT_LT(alone, 0.3 * beside);
}

}  // namespace
}  // namespace nao::validation
