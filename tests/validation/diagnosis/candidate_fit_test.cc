#include "validation/diagnosis/candidate_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/joint_data.h"

namespace nao::validation {
namespace {

constexpr JointNoise kNoNoise{};

// Beyond which damping, by how many times what is beyond, and how much of that in threefold time.
struct Bend {
  double at, shakes = 20, threefold = 1;
};

// A joint that damping drags along: by as much as there is up to a bend, then it cannot follow at
// all and shakes.
class BendingJoint final : public JointSimulator {
 public:
  BendingJoint(double damping, Bend bend) : bend_(bend) {
    for (std::size_t m = 0; m < 3; ++m) {
      JointMotion motion{
          "motion" + std::to_string(m), m < 2 ? Split::Fit : Split::Select, 0.01, {}};
      for (std::uint64_t r = 0; r < 6; ++r) {
        motion.repeats.push_back(angle(damping, m, 1000 + 10 * m + r));
      }
      measured_.push_back(std::move(motion));
    }
  }

  std::string joint() const override { return "Bending"; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise&) const override {
    double damping = 0;
    for (const EffectSetting& cause : causes) damping += cause.parameters.at("coefficient");
    return angle(damping, motion, stream);
  }

 private:
  Eigen::MatrixXd angle(double damping, std::size_t motion, std::uint64_t stream) const {
    Random random(stream, "bending");
    const double shaken = bend_.shakes * std::max(0.0, damping - bend_.at),
                 dragged = damping + shaken;
    Eigen::MatrixXd angle(300, 1);
    for (Eigen::Index k = 0; k < angle.rows(); ++k) {
      const double t = 0.01 * static_cast<double>(k), w = 2 + static_cast<double>(motion);
      angle(k, 0) = std::sin(w * t) - 0.1 * dragged * std::cos(w * t) -
                    0.1 * bend_.threefold * shaken * std::cos(3 * w * t) + 1e-3 * random.normal();
    }
    return angle;
  }

  Bend bend_;
  std::vector<JointMotion> measured_;
};

class DampedJoint : public testing::Test {
 protected:
  explicit DampedJoint(double damping = 0.08, Bend bend = {0.1}) : joint_(damping, bend) {}

  static std::vector<Cause> damping() {
    for (const Cause& cause : jointCauses()) {
      if (cause.id == "viscous_friction") return {cause};
    }
    return {};
  }
  static std::vector<Cause> bounded(std::vector<Cause> causes, const JointSimulator& joint) {
    for (Cause& cause : causes) cause = boundedAt(cause, joint, sim::standardEffects());
    return causes;
  }

  BendingJoint joint_;
  std::vector<Cause> causes_ = bounded(damping(), joint_);
  Effort effort_;
  JointData data_{joint_, kNoNoise};
  Ensemble ensemble_{joint_, data_, kNoNoise, 1000000};
  Stage stage_{ensemble_, data_, causes_, {}, Eigen::MatrixXd(data_.size(), 0), effort_};
  QuickFit start_ = startsFor(stage_, causes_, stage_.white(stage_.raw()), 10, 1).front();
};

TEST_F(DampedJoint, ALookThatIsLargerDoesNotSpeakForASmallerSizeItKnowsNothingOf) {
  ASSERT_NEAR(start_.x[0], 0.08, 0.002);  // by the look at 0.05; that at 0.3 drags 4.1
  const QuickFit fit = fitQuickly(ensemble_, stage_, causes_, start_, effort_);
  EXPECT_NEAR(fit.x[0], 0.08, 0.002);
  EXPECT_GT(fit.gain, 0.9 * start_.gain);
}

TEST_F(DampedJoint, NorInAFullFit) {
  const CauseList model{{start_.cause, start_.x}};
  const ModelFit fit = fitFully(ensemble_, data_, stage_, causes_, model, effort_, start_.gain);
  EXPECT_NEAR(fit.model[0].x[0], 0.08, 0.002);
  EXPECT_GT(fit.gain, 0.9 * start_.gain);
}

TEST_F(DampedJoint, FromTwiceTheSizeAFitComesBack) {
  const QuickFit fit = fitQuickly(ensemble_, stage_, causes_, {0, {0.16}, start_.gain}, effort_);
  EXPECT_NEAR(fit.x[0], 0.08, 0.005);
}

// Every look is beyond the bend.
class LightlyDampedJoint : public DampedJoint {
 protected:
  LightlyDampedJoint() : DampedJoint(0.0075, {0.01}) {}
};

TEST_F(LightlyDampedJoint, WhatASizeDoesItselfCountsIfItIsMoreThanALargerLookMakesOfIt) {
  ASSERT_LT(start_.x[0], 0.001);
  const QuickFit fit = fitQuickly(ensemble_, stage_, causes_, start_, effort_);
  EXPECT_NEAR(fit.x[0], 0.0075, 0.0005);
  EXPECT_GT(fit.gain, 1.5 * start_.gain);
}

// Scaled down, the look at 0.05 makes 0.0049 of it and explains three quarters of what 0.009 does.
class MildlyBentJoint : public DampedJoint {
 protected:
  MildlyBentJoint() : DampedJoint(0.009, {0.01, 0.5, 2}) {}
};

// A torque of 0.039 N m was told as a tilt: the look at 0.1 the other way explains two thirds.
TEST_F(MildlyBentJoint, AFullFitDoesNotFallBehindWhatTheSizeWasSeenToGain) {
  const QuickFit quick = fitQuickly(ensemble_, stage_, causes_, start_, effort_);
  ASSERT_NEAR(quick.x[0], 0.009, 0.0005);
  const CauseList model{{0, quick.x}};
  const ModelFit fit = fitFully(ensemble_, data_, stage_, causes_, model, effort_, quick.gain);
  EXPECT_NEAR(fit.model[0].x[0], 0.009, 0.0005);
  EXPECT_GT(fit.gain, 0.95 * quick.gain);
}

}  // namespace
}  // namespace nao::validation
