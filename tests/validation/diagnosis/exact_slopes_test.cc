#include "validation/diagnosis/exact_slopes.h"

#include <gtest/gtest.h>

#include <cmath>

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

// Damping drags it along; beyond a cliff it moves a hundred times as far. Runs of different damping
// part ways by chance.
class CliffJoint final : public JointSimulator {
 public:
  CliffJoint() {
    measured_ = {{"fit", Split::Fit, 0.01, {}}, {"select", Split::Select, 0.01, {}}};
    for (JointMotion& motion : measured_) {
      for (std::uint64_t r = 0; r < 6; ++r) motion.repeats.push_back(angle(kDamping, 1000 + r));
    }
  }

  std::string joint() const override { return "Cliff"; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise&) const override {
    double damping = 0;
    for (const EffectSetting& cause : causes) damping += cause.parameters.at("coefficient");
    return angle(damping, 10 * stream + motion);
  }

 private:
  static Eigen::MatrixXd angle(double damping, std::uint64_t stream) {
    Random random(stream, std::to_string(damping));
    Eigen::MatrixXd angle = kDrag * (damping > kCliff ? 100 : 1) * damping * drag(300);
    for (Eigen::Index k = 0; k < angle.rows(); ++k) angle(k, 0) += 4e-3 * random.normal();
    return angle;
  }

  std::vector<JointMotion> measured_;
};

Cause dampingOf(const JointSimulator& joint) {
  for (const Cause& cause : jointCauses()) {
    if (cause.id == "viscous_friction") return boundedAt(cause, joint, sim::standardEffects());
  }
  return {};
}

// Within 0.0064 or 0.0192 a difference is mostly chance, but half the number leads over the cliff,
// where the slope is 150 times as steep. A friction near standstill of 1.4 N m was told as 1.3994
// to 1.4000 by such a one.
TEST(ExactSlopes, AreNotWidenedOverACliff) {
  const CliffJoint joint;
  const std::vector<Cause> causes{dampingOf(joint)};
  const JointData data(joint, kNoNoise);
  Ensemble ensemble(joint, data, kNoNoise, 1000000);
  const Effort effort;
  const CauseList model{{0, {kDamping}}};
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(data.size(), 1);
  const Stage stage(ensemble, data, causes, model, none, effort);
  ModelFit fit;
  fit.model = model;
  fit.jacobian = fit.chance = none;
  setExactSlopes(ensemble, causes, effort.slope_runs, stage, fit);
  const Eigen::VectorXd course = drag(300);
  const double slope = fit.jacobian.col(0).head(300).dot(course) / course.squaredNorm();
  // [rad] SD of a mean of four runs to either side, over twice the narrowest step.
  const double sd = 4e-3 / std::sqrt(4.0) * std::sqrt(2.0) / (2 * 0.0064) / course.norm();
  EXPECT_NEAR(slope, kDrag, 4 * sd);
}

}  // namespace
}  // namespace nao::validation
