#include "validation/diagnosis/joint/exact_slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/validation/diagnosis/law_joint.h"

namespace nao::validation {
namespace {

using test::drag;
using test::kNoNoise;
using test::LawJoint;
using test::LawSearch;

constexpr double kDamping = 0.08, kCliff = 0.1;
constexpr double kDrag = -0.1;  // [rad] per unit of damping

// Of a model of this cause alone, along drag().
double slopeAt(const JointSimulator& joint, const std::string& id, std::vector<double> x) {
  const std::vector<Cause> causes{LawSearch::bounded(id, joint)};
  const JointData data(joint, kNoNoise);
  Ensemble ensemble(joint, data, kNoNoise, 1000000);
  const Effort effort;
  ModelFit fit;
  fit.model = {{0, x}};
  fit.jacobian = fit.chance =
      Eigen::MatrixXd::Zero(data.size(), static_cast<Eigen::Index>(x.size()));
  const Stage stage(ensemble, data, causes, fit.model, fit.jacobian, effort);
  setExactSlopes(ensemble, causes, effort.slope_runs, stage, fit);
  const Eigen::VectorXd course = drag(300);
  return fit.jacobian.col(0).head(300).dot(course) / course.squaredNorm();
}

// Within 0.0064 or 0.0192 a difference is mostly chance, but half the number leads over the cliff,
// where the slope is 150 times as steep. A friction near standstill of 1.4 N m was told as 1.3994
// to 1.4000 by such a one.
TEST(ExactSlopes, AreNotWidenedOverACliff) {
  const LawJoint joint("coefficient", kDamping, 4e-3, [](double damping) {
    return kDrag * (damping > kCliff ? 100 : 1) * damping;
  });
  // [rad] SD of a mean of four runs to either side, over twice the narrowest step.
  const double sd = 4e-3 / std::sqrt(4.0) * std::sqrt(2.0) / (2 * 0.0064) / drag(300).norm();
  EXPECT_NEAR(slopeAt(joint, "viscous_friction", {kDamping}), kDrag, 4 * sd);
}

// A stop that moves by 0.14 rad/rad is reached from 0.11 on. A difference as wide as the size of
// interest, 0.05 to either side, took the way there for half of it: intervals of coupled stops held
// one truth of four.
TEST(ExactSlopes, OfACoupledStopDoNotReachBeyondWhereItIsMet) {
  const LawJoint joint("upper", 0.14, 1e-6,
                       [](double slope) { return 0.1 * std::max(0.0, slope - 0.11); });
  EXPECT_NEAR(slopeAt(joint, "coupled_stop.upper", {0.14, 0}), 0.1, 1e-3);
}

}  // namespace
}  // namespace nao::validation
