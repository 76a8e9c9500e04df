#include "validation/diagnosis/rig/rig_simulator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/models.h"
#include "validation/diagnosis/ensemble/noise_fit.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/diagnosis/rig/led_joint.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

const JointNoise kNoise{0.1, 0.05, 5e-4, 0, 0};

std::vector<EffectSetting> torqueNoise() {
  return {{"process_noise", {{"sd", kNoise.torque_sd}, {"time", kNoise.torque_time}}, {}, ""}};
}

// The limb of `joint`, hung up, in two standard motions of six runs by a World at 0.25 ms.
struct Recorded {
  explicit Recorded(const char* joint, const std::vector<EffectSetting>& hidden = {},
                    const char* robot = "nao_h21_v33", std::uint64_t seed = 1) {
    model = std::make_shared<RobotModel>(
        cutLimbs(stripped(suspend(*nao::test::robot(robot))), {joint}));
    RecordingPlan plan;
    plan.model = model;
    plan.motions = standardRecording(model);
    plan.motions = {plan.motions[0], plan.motions[3]};  // slow ramps, fast ramps and steps
    plan.extra = torqueNoise();
    plan.extra.insert(plan.extra.end(), hidden.begin(), hidden.end());
    plan.start_sd = kNoise.start_sd;
    plan.seed = seed;
    set = std::make_shared<RigSet>(recordSimulated(plan), model);
  }

  JointReplay replay(const char* joint, const std::vector<EffectSetting>& causes = {}) const {
    const RigSimulator simulator(set, *model->findJoint(joint));
    return replayJoint(simulator, causes, kNoise, 24, {Split::Fit});
  }

  EffectSetting effect(const char* name, std::map<std::string, double> parameters,
                       const char* joint) const {
    return {name, std::move(parameters), {*model->findJoint(joint)}, ""};
  }

  std::shared_ptr<RobotModel> model;
  std::shared_ptr<const RigSet> set;
};

// A perfect model's misfit is 1 but for chance: 12 s are 120 independent samples of a torque with a
// memory of 0.05 s, +-6 % of a joint's misfit. A rig is not quite perfect: how its neighbours
// rattle in their play is left out (LHipPitch is worst, 1.43; 1.12 over three sets' four joints).
constexpr double kNull = 1.25, kLargestOfTwelve = 1.6, kMean = 1.2;

TEST(RigSimulator, OfAPerfectModelNoiseExplainsAll) {
  double noise_free = 0, squares = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Recorded legs("LKneePitch", {}, "nao_h21_v33", seed);
    for (const char* joint : {"LHipYawPitch", "LHipPitch", "LKneePitch", "LAnkleRoll"}) {
      const JointReplay replay = legs.replay(joint);
      EXPECT_LT(replay.misfit, kLargestOfTwelve) << joint;
      EXPECT_GT(replay.misfit, 0.5) << joint;
      EXPECT_NEAR(replay.simulated_sd, replay.real_sd, 0.25 * replay.real_sd) << joint;
      squares += replay.misfit * replay.misfit / 12;
      noise_free += replay.noise_free_rmse / replay.rmse / 3;
    }
  }
  EXPECT_LT(std::sqrt(squares), kMean);
  EXPECT_GT(std::sqrt(squares), 1 / kMean);
  // Without noise play comes to rest elsewhere: a perfect model would look wrong. By much in joints
  // that linger, hardly in those that are always driven.
  EXPECT_GT(noise_free, 4 * 1.1);
}

// A joint of which a model does not know a torque, led beside that model's course along its own.
struct Biased {
  static constexpr double kBias = 0.1;  // [N m]
  explicit Biased(const char* name, std::size_t motion)
      : recorded(name),
        simulator(recorded.set, *recorded.model->findJoint(name)),
        bias(recorded.effect("torque_bias", {{"torque", kBias}}, name)),
        own(simulator.run({}, motion, 0, {}).col(0)),
        nothing(Eigen::VectorXd::Zero(own.size())),
        lacked(simulator.led({}, motion, simulator.run({bias}, motion, 0, {}).col(0) - own, nothing)
                   .torque) {
    const Actuator& motor = recorded.model->actuators[index(*recorded.model->findJoint(name))];
    const double spring = motor.rotor_inertia * (1 + simulator.linkInertia()) * 250 * 250;
    part = spring / (spring + motor.kp);
  }

  Recorded recorded;
  RigSimulator simulator;
  EffectSetting bias;
  Eigen::VectorXd own, nothing, lacked;
  double part = 0;  // that the servo leaves to the spring, as this gives
};

TEST(RigSimulator, LackedIsTheTorqueThatTheModelHasNot) {
  const Biased elbow("LElbowRoll", 0);
  EXPECT_NEAR(elbow.lacked.mean(), elbow.part * Biased::kBias, 0.03 * Biased::kBias);
  const LedRun with = elbow.simulator.led({elbow.bias}, 0, elbow.nothing, elbow.nothing);
  EXPECT_LT(with.torque.norm(), 1e-6 * elbow.lacked.norm());
  // Where the encoder reads too much, so does the servo: the same course turned back, led alike.
  const Eigen::VectorXd wrong = Eigen::VectorXd::Constant(elbow.own.size(), 0.05);
  const LedRun misread = elbow.simulator.led({elbow.bias}, 0, -wrong, wrong);
  EXPECT_NEAR((misread.error - with.error).norm(), 0, 0.02 * with.error.norm());
}

// A joint that follows the steps of fast commands moves by jerks, and its servo gives all that it
// has in between. Led along the smooth course that its readings tell, 3.8 rad/s, it seemed to lack
// a tenth of what it lacks.
TEST(RigSimulator, LackedIsAsMuchWhereAJointIsFast) {
  const Biased head("HeadYaw", 1);
  const Eigen::VectorXd rate = withRates(head.own, 0.01).col(1);
  double sum = 0;
  int rows = 0;
  for (Eigen::Index i = 0; i < rate.size(); ++i) {
    if (std::abs(rate[i]) < 2) continue;
    sum += head.lacked[i];
    ++rows;
  }
  EXPECT_GT(rows, 50);
  EXPECT_NEAR(sum / rows, head.part * Biased::kBias, 0.15 * Biased::kBias);
}

TEST(RigSimulator, KnowsWhatTheWorldHides) {
  const EffectSetting friction{"coulomb_friction", {{"torque", 0.25}}, {}, ""};
  const Recorded arm("LElbowRoll", {friction});
  EXPECT_GT(arm.replay("LElbowRoll").misfit, 3);
  EXPECT_LT(arm.replay("LElbowRoll", {friction}).misfit, kNull);
  EXPECT_LT(arm.replay("LShoulderPitch", {friction}).misfit, kNull);
}

// A whole arm of which two joints move and are written, the others are never seen.
struct SeenInPart {
  explicit SeenInPart(const std::vector<std::string>& joints, bool noisy,
                      const std::vector<EffectSetting>& hidden = {}) {
    model = std::make_shared<RobotModel>(
        cutLimbs(stripped(suspend(*nao::test::robot("nao_h21_v33"))), joints));
    RecordingPlan plan;
    plan.model = model;
    plan.motions = standardRecording(model);
    moveOnly(joints, model, plan.motions);
    plan.joints = joints;
    plan.repeats = noisy ? 3 : 1;
    if (noisy) plan.extra = torqueNoise();
    plan.extra.insert(plan.extra.end(), hidden.begin(), hidden.end());
    set = std::make_shared<RigSet>(recordSimulated(plan), model);
  }
  std::shared_ptr<RobotModel> model;
  std::shared_ptr<const RigSet> set;
};

TEST(RigSimulator, StaysFiniteWithLinksOfHardlyAnyMass) {
  const SeenInPart arm({"LShoulderPitch", "LElbowRoll"}, true);
  const RigSimulator shoulder(arm.set, *arm.model->findJoint("LShoulderPitch"));
  const RigSimulator elbow(arm.set, *arm.model->findJoint("LElbowRoll"));
  const EffectSetting light{
      "link_mass", {{"part", -0.94}}, {*arm.model->findJoint("LElbowRoll")}, ""};
  for (const RigSimulator* joint : {&shoulder, &elbow}) {
    for (std::size_t m = 0; m < joint->measured().size(); ++m) {
      EXPECT_TRUE(joint->run({light}, m, 1, kNoise).allFinite());
      EXPECT_TRUE(joint->coarse().run({light}, m, 1, kNoise).allFinite());
    }
  }
}

// [rad] RMS between what a twin without noise predicts with these effects and the World.
double errorOf(const SeenInPart& limb, const char* name,
               const std::vector<EffectSetting>& effects) {
  const RigSimulator joint(limb.set, *limb.model->findJoint(name));
  double square = 0;
  for (std::size_t m = 0; m < joint.measured().size(); ++m) {
    const Eigen::VectorXd real = joint.measured()[m].repeats[0].col(0);
    square += (joint.run(effects, m, 1, {}).col(0) - real).array().square().mean();
  }
  return std::sqrt(square / static_cast<double>(joint.measured().size()));
}

constexpr double kPartOfACount = 0.4e-3;  // [rad] An encoder of a Nao counts 1.5 mrad.

// What joints do that nobody wrote down is calculated, not taken to be rest.
TEST(RigSimulator, FollowsTheWorldThoughOneJointAloneIsSeen) {
  for (const char* name : {"LShoulderPitch", "LKneePitch"}) {
    EXPECT_LT(errorOf(SeenInPart({name}, false), name, {}), kPartOfACount) << name;
  }
}

// What moves a joint otherwise shakes its neighbours otherwise, and they it: with the load of the
// nominal model a weaker motor's twin was 8 mrad off.
TEST(RigSimulator, FollowsTheWorldWhateverActsOnTheJoint) {
  for (const EffectSetting& effect : {EffectSetting{"torque_limit", {{"part", 0.6}}, {}, ""},
                                      EffectSetting{"command_latency", {{"delay", 0.01}}, {}, ""},
                                      EffectSetting{"cable_spring", {{"stiffness", 0.4}}, {}, ""},
                                      EffectSetting{"motor_inertia", {{"part", 0.5}}, {}, ""}}) {
    const SeenInPart arm({"RShoulderRoll"}, false, {effect});
    EXPECT_LT(errorOf(arm, "RShoulderRoll", {effect}), kPartOfACount) << effect.name;
  }
}

TEST(RigSimulator, CalculatesLoadsAnewForOtherMasses) {
  const Recorded nominal("LElbowRoll");
  const EffectSetting payload =
      nominal.effect("payload", {{"mass", 0.3}, {"x", 0.1}}, "LElbowRoll");
  const EffectSetting tilt{"ground_tilt", {{"x", 0}, {"y", 0.4}}, {}, ""};
  const Recorded arm("LElbowRoll", {payload, tilt});
  EXPECT_GT(arm.replay("LShoulderPitch").misfit, 3);
  EXPECT_LT(arm.replay("LShoulderPitch", {payload, tilt}).misfit, kNull);
}

TEST(RigSimulator, DrawsByStreamAloneWhateverTheCauses) {
  const Recorded head("HeadYaw");
  const RigSimulator simulator(head.set, *head.model->findJoint("HeadYaw"));
  const auto angles = [&](const std::vector<EffectSetting>& causes, std::uint64_t stream) {
    return Eigen::VectorXd(simulator.run(causes, 0, stream, kNoise).col(0));
  };
  EXPECT_EQ(angles({}, 3), angles({}, 3));
  EXPECT_NE(angles({}, 3), angles({}, 4));
  const EffectSetting gain = head.effect("kp_error", {{"part", 0.01}}, "HeadYaw");
  const double by_cause = (angles({gain}, 3) - angles({}, 3)).norm();
  const double by_stream = (angles({}, 4) - angles({}, 3)).norm();
  EXPECT_LT(by_cause, 0.5 * by_stream);
}

// Three sets of two motions of six runs: their starts are drawn 36 times, which tells an SD to 13
// %, and what the torque makes runs look late is taken off.
TEST(NoiseFit, FindsTheNoiseOfRepeats) {
  double torque = 0, start = 0;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Recorded arm("LElbowRoll", {{"encoder_jitter", {{"amplitude", 0.003}}, {}, ""}},
                       "nao_h21_v33", seed);
    const RigSimulator simulator(arm.set, *arm.model->findJoint("LElbowRoll"));
    const JointNoise found = fitNoise(simulator, {0.02, 0.02, 0, 0, 0});
    torque += found.torque_sd / 3;
    start += found.start_sd * found.start_sd / 3;
    EXPECT_NEAR(found.jitter, 0.003, 0.0005);
    const NoiseComparison before = compareNoise(simulator, {0.02, 0.02, 0, 0, 0});
    EXPECT_GT(before.measured.sd, 2 * before.simulated.sd);
    const NoiseComparison after = compareNoise(simulator, found);
    EXPECT_NEAR(after.simulated.sd, after.measured.sd, 0.15 * after.measured.sd);
  }
  EXPECT_NEAR(torque, kNoise.torque_sd, 0.3 * kNoise.torque_sd);
  EXPECT_NEAR(std::sqrt(start), kNoise.start_sd, 0.4 * kNoise.start_sd);
}

TEST(NoiseFit, StartsFromTheRobotsFile) {
  const auto nao = nao::test::robot("nao_h21_v33");
  const JointNoise knee = nominalNoise(*nao, *nao->findJoint("LKneePitch"));
  const JointNoise head = nominalNoise(*nao, *nao->findJoint("HeadYaw"));
  EXPECT_GT(knee.torque_sd, head.torque_sd);
  EXPECT_GT(head.torque_sd, 0);
  EXPECT_GT(knee.jitter, 0);
  EXPECT_EQ(knee.start_sd, nao->start_sd);
  const auto pendulum = nao::test::pendulum(1, 0.1);  // says nothing of its noise
  EXPECT_GT(nominalNoise(*pendulum, toJoint(0)).torque_sd, 0);
}

// As a robot does whose zeros were set in software: the encoder counts as before.
TEST(RigSimulator, ReadsTheCountsThatTheLogHas) {
  const auto model = std::make_shared<RobotModel>(
      cutLimbs(stripped(suspend(*nao::test::robot("nao_h21_v33"))), {"HeadYaw"}));
  RecordingPlan plan;
  plan.model = model;
  plan.motions = {standardRecording(model).front()};
  plan.repeats = 1;
  LogSet set = recordSimulated(plan);
  constexpr double kCount = 2 * M_PI / 4096, kBeside = 0.4 * kCount;  // [rad]
  for (double& angle : set.runs.at(0).columns["q.HeadYaw"]) angle += kBeside;
  for (const Split split : {Split::Fit, Split::Test}) {  // of a blind set all are test runs
    set.runs[0].split = split;
    const RigSimulator simulator(std::make_shared<RigSet>(set, model),
                                 *model->findJoint("HeadYaw"));
    const Eigen::MatrixXd run = simulator.run({}, 0, 1, {});
    for (Eigen::Index row = 0; row < run.rows(); ++row) {
      const double counts = (run(row, 0) - kBeside) / kCount;
      ASSERT_NEAR(counts, std::round(counts), 1e-3) << row;  // a robot's file rounds the count
    }
  }
}

TEST(RigSimulator, RefusesARobotOnItsFeet) {
  LogSet set;
  set.rate = 100;
  EXPECT_THROW(RigSet(set, nao::test::robot("nao_h21_v33")), InputError);
}

}  // namespace
}  // namespace nao::validation
