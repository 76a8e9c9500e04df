#include "validation/diagnosis/exact_slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/random.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/joint_data.h"

namespace nao::validation {
namespace {

constexpr double kDamping = 0.08, kCliff = 0.1;
constexpr double kDrag = -0.1;  // [rad] per unit of damping
constexpr JointNoise kNoNoise{};

Eigen::VectorXd drag(Eigen::Index rows) {
  Eigen::VectorXd course(rows);
  for (Eigen::Index k = 0; k < rows; ++k) course[k] = std::cos(0.02 * static_cast<double>(k));
  return course;
}

// Moves as a law says of one number; runs of different numbers part ways by chance.
class LawJoint final : public JointSimulator {
 public:
  LawJoint(std::string parameter, double number, double chance, std::function<double(double)> law)
      : parameter_(std::move(parameter)), chance_(chance), law_(std::move(law)) {
    measured_ = {{"fit", Split::Fit, 0.01, {}}, {"select", Split::Select, 0.01, {}}};
    for (JointMotion& motion : measured_) {
      for (std::uint64_t r = 0; r < 6; ++r) motion.repeats.push_back(angle(number, 1000 + r));
    }
  }

  std::string joint() const override { return "Law"; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise&) const override {
    double number = 0;
    for (const EffectSetting& cause : causes) number += cause.parameters.at(parameter_);
    return angle(number, 10 * stream + motion);
  }

 private:
  Eigen::MatrixXd angle(double number, std::uint64_t stream) const {
    Random random(stream, std::to_string(number));
    Eigen::MatrixXd angle = law_(number) * drag(300);
    for (Eigen::Index k = 0; k < angle.rows(); ++k) angle(k, 0) += chance_ * random.normal();
    return angle;
  }

  std::string parameter_;
  double chance_;
  std::function<double(double)> law_;
  std::vector<JointMotion> measured_;
};

// Of a model of this cause alone, along drag().
double slopeAt(const JointSimulator& joint, const std::string& id, std::vector<double> x) {
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    if (cause.id == id) causes.push_back(boundedAt(cause, joint, sim::standardEffects()));
  }
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

// Of coarse fits too: within 0.02 and 0.06 a difference is mostly chance, 0.2 leads over the cliff.
// An elbow that 1.74 N m hold near standstill was fitted by 1.25 N m, a root, a gain and an
// inertia.
TEST(CandidateFit, DoesNotWidenItsStepsOverACliff) {
  constexpr double kTruth = 0.5, kEdge = 0.6;
  const LawJoint joint("part", kTruth, 4e-3,
                       [](double part) { return kDrag * (part > kEdge ? 100 : 1) * part; });
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    if (cause.id == "duty_root") causes.push_back(boundedAt(cause, joint, sim::standardEffects()));
  }
  const JointData data(joint, kNoNoise);
  Ensemble ensemble(joint, data, kNoNoise, 1000000);
  const Effort effort;
  const Stage stage(ensemble, data, causes, {}, Eigen::MatrixXd(data.size(), 0), effort);
  const ModelFit fit = fitFully(ensemble, data, stage, causes, {{0, {0.42}}}, effort);
  // [1] SD of what eight runs tell of the number, twice as one mean is subtracted from another.
  const double sd = 4e-3 * std::sqrt(2.0 / 8) / (std::abs(kDrag) * drag(300).norm());
  EXPECT_NEAR(fit.model[0].x[0], kTruth, 4 * sd);
}

}  // namespace
}  // namespace nao::validation
