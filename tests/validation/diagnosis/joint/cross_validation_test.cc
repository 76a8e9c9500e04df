#include "validation/diagnosis/joint/cross_validation.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/random.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

using ByMotion = std::array<double, 3>;  // two motions to fit, one to select

// A joint whose damping bends a motion by so much of itself; what was measured is a damping of its
// own in every motion.
class PartlyDamped final : public JointSimulator {
 public:
  PartlyDamped(const ByMotion& felt, const ByMotion& measured) : felt_(felt) {
    for (std::size_t m = 0; m < measured.size(); ++m) {
      JointMotion motion{
          "motion" + std::to_string(m), m < 2 ? Split::Fit : Split::Select, 0.01, {}};
      for (std::uint64_t r = 0; r < 6; ++r) {
        motion.repeats.push_back(angle(measured[m], m, 1000 + 10 * m + r));
      }
      measured_.push_back(std::move(motion));
    }
  }

  std::string joint() const override { return "Partly"; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise&) const override {
    double damping = 0;
    for (const EffectSetting& cause : causes) damping += cause.parameters.at("coefficient");
    return angle(felt_[motion] * damping, motion, stream);
  }

 private:
  static Eigen::MatrixXd angle(double bend, std::size_t motion, std::uint64_t stream) {
    Random random(stream, "partly");
    Eigen::MatrixXd angle(300, 1);
    for (Eigen::Index k = 0; k < angle.rows(); ++k) {
      const double t = 0.01 * static_cast<double>(k), w = 2 + static_cast<double>(motion);
      angle(k, 0) = std::sin(w * t) - 0.1 * bend * std::cos(3 * w * t) + 1e-3 * random.normal();
    }
    return angle;
  }

  ByMotion felt_;
  std::vector<JointMotion> measured_;
};

// Of the damping that fits a joint best.
CrossValidation validated(const ByMotion& felt, const ByMotion& measured) {
  const PartlyDamped joint(felt, measured);
  std::vector<Cause> causes;
  for (const Cause& cause : jointCauses()) {
    if (cause.id == "viscous_friction") {
      causes.push_back(boundedAt(cause, joint, sim::standardEffects()));
    }
  }
  const JointNoise none{};
  const Effort effort;
  const JointData data(joint, none);
  Ensemble ensemble(joint, data, none, 1000000);
  Stage stage(ensemble, data, causes, {}, Eigen::MatrixXd(data.size(), 0), effort);
  stage.lookAround();
  const auto starts = startsFor(stage, causes, stage.white(stage.raw()), 1, 1);
  EXPECT_FALSE(starts.empty());
  const CauseList model{{0, starts.front().x}};
  const ModelFit fit = fitFully(ensemble, data, stage, causes, model, effort, starts.front().gain);
  return crossValidate(data, stage, fit, 1);
}

TEST(CrossValidation, ACauseThatPredictsEveryMotionIsAccepted) {
  const CrossValidation found = validated({1, 1, 1}, {0.08, 0.08, 0.08});
  EXPECT_EQ(found.folds, 5);  // two motions, the motion to select, odd and even seconds
  EXPECT_EQ(found.better, 5);
  EXPECT_GT(found.gain, 0);
  EXPECT_FALSE(found.oneMotionOnly());
  EXPECT_TRUE(found.accepted());
}

TEST(CrossValidation, ACauseThatActsInOneMotionIsNotVetoedByTheOthers) {
  const CrossValidation found = validated({1, 0, 0}, {0.08, 0, 0});
  EXPECT_TRUE(found.oneMotionOnly());
  EXPECT_EQ(found.folds, 2);  // odd and even seconds of that motion
  EXPECT_TRUE(found.accepted());
}

TEST(CrossValidation, ACauseThatMotionsDisagreeOnIsNotAccepted) {
  const CrossValidation found = validated({1, -1, 1}, {0.09, 0.03, 0});
  EXPECT_FALSE(found.oneMotionOnly());
  EXPECT_FALSE(found.accepted()) << found.better << " of " << found.folds;
}

}  // namespace
}  // namespace nao::validation
