#include "validation/diagnosis/ensemble/noise_fit.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"

namespace nao::validation {
namespace {

constexpr JointNoise kTrue{0.03, 0.05, 0.001};
constexpr JointNoise kBegin{0.1, 0.02, 0};

// What moves a joint slowly: the torque's variance times how long it lasts.
double powerOf(const JointNoise& noise) {
  return noise.torque_sd * noise.torque_sd * noise.torque_time;
}

double meanPower(const test::ToyLaws& laws, const std::vector<EffectSetting>& causes = {}) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    sum += powerOf(fitNoise(test::ToyJoint(laws, seed, kTrue), kBegin, causes)) / 4;
  }
  return sum / powerOf(kTrue);
}

// 25 seconds of six runs, of which one in ten samples is independent, know a variance to 10 %; the
// correlation time lies on a grid whose steps are 1.5.
TEST(FitNoise, FindsWhatShookTheRuns) {
  const double power = meanPower({});
  EXPECT_GT(power, 0.75);
  EXPECT_LT(power, 1.35);
}

// A toy that rattles by a few mrad in one second of six, a run with it and the next against it.
class RattlingToy final : public JointSimulator {
 public:
  explicit RattlingToy(std::uint64_t seed) : toy_({}, seed, kTrue), measured_(toy_.measured()) {
    for (JointMotion& motion : measured_) {
      double way = 0.007;
      for (Eigen::MatrixXd& run : motion.repeats) {
        for (Eigen::Index i = 100; i < 200; ++i)
          run(i, 0) += way * std::sin(0.3 * static_cast<double>(i));
        way = -way;
      }
    }
  }
  std::string joint() const override { return toy_.joint(); }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override {
    return toy_.run(causes, motion, stream, noise);
  }

 private:
  test::ToyJoint toy_;
  std::vector<JointMotion> measured_;
};

TEST(FitNoise, IsNotMisledByWhatHappensInSomeSeconds) {
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const RattlingToy rattling(seed);
    ASSERT_GT(momentsOf(rattling.measured()).sd,
              1.1 * momentsOf(test::ToyJoint({}, seed, kTrue).measured()).sd);
    sum += powerOf(fitNoise(rattling, kBegin)) / powerOf(kTrue) / 4;
  }
  EXPECT_LT(sum, 1.6);
}

// A toy that hardly feels what shakes it, as one that sticks.
class StuckToy final : public JointSimulator {
 public:
  std::string joint() const override { return toy_.joint(); }
  const std::vector<JointMotion>& measured() const override { return toy_.measured(); }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override {
    JointNoise little = noise;
    little.torque_sd *= 1e-3;
    return toy_.run(causes, motion, stream, little);
  }

 private:
  test::ToyJoint toy_{{}, 1, kTrue};
};

// A head that stuck with 3 % less torque asked for 22 N m, and its diagnosis ended there.
TEST(FitNoise, NamesNoTorqueThatTheEffectCanNotHave) {
  EXPECT_EQ(fitNoise(StuckToy(), kBegin).torque_sd, 5);  // [N m] the catalogue's
  EXPECT_EQ(fitNoise(StuckToy(), {40, 0.05, 0}).torque_sd, 5);
}

TEST(FitNoise, KnowsWhatACauseDoesToIt) {
  test::ToyLaws soft;
  soft.kp = 11;
  const double as_nominal = meanPower(soft);
  const double with_cause = meanPower(soft, {{"kp_error", {{"part", -0.5}}, {}, ""}});
  EXPECT_GT(as_nominal, 1.5);  // a soft joint is moved further
  EXPECT_GT(with_cause, 0.75);
  EXPECT_LT(with_cause, 1.35);
}

}  // namespace
}  // namespace nao::validation
