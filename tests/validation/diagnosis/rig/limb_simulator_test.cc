#include "validation/diagnosis/rig/limb_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/hinge_run.h"
#include "tests/support/models.h"
#include "validation/diagnosis/causes/causes.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/diagnosis/rig/run_noise.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

// A limb (both legs are one) of which these joints move and are written, by a World at 0.25 ms
// without noise.
struct RecordedLimb {
  explicit RecordedLimb(const std::vector<std::string>& joints,
                        const std::vector<EffectSetting>& hidden = {}) {
    model = std::make_shared<RobotModel>(
        cutLimbs(stripped(suspend(*nao::test::robot("nao_h21_v33"))), joints));
    RecordingPlan plan;
    plan.model = model;
    plan.motions = standardRecording(model);
    plan.motions = {plan.motions[0], plan.motions[3]};
    moveOnly(joints, model, plan.motions);
    plan.joints = joints;
    plan.repeats = 1;
    plan.extra = hidden;
    set = std::make_shared<RigSet>(recordSimulated(plan), model);
  }

  Joint joint(const char* name) const { return *model->findJoint(name); }

  // [rad], [A] RMS between what is predicted and what was recorded.
  Eigen::RowVector2d errorOf(const char* name, const std::vector<EffectSetting>& effects) const {
    const RigSimulator rig(set, joint(name));
    Eigen::RowVector2d square = Eigen::RowVector2d::Zero();
    for (std::size_t m = 0; m < 2; ++m) {
      const Eigen::MatrixXd beside =
          rig.exact().run(effects, m, 1, {}) - rig.measured()[m].repeats[0];
      square += beside.colwise().squaredNorm() / static_cast<double>(2 * beside.rows());
    }
    return square.cwiseSqrt();
  }

  std::shared_ptr<RobotModel> model;
  std::shared_ptr<const RigSet> set;
};

// But for its inertia, which is of every millisecond: play in gears makes chance of any difference,
// a twentieth of a count RMS; with inertia of every step it is below 1e-9.
TEST(LimbSimulator, IsTheWorldOfItsLimb) {
  const EffectSetting friction{"coulomb_friction", {{"torque", 0.2}}, {}, ""};
  const RecordedLimb arm({"RShoulderRoll"}, {friction});
  const Eigen::RowVector2d error = arm.errorOf("RShoulderRoll", {friction});
  EXPECT_LT(error[0], 75e-6);
  EXPECT_LT(error[1], 1e-3);
  EXPECT_GT(arm.errorOf("RShoulderRoll", {}).minCoeff(), 1e-3);
}

// A torque of 3 N m holds the elbow 0.04 rad off: only its measured angles say so to the shoulder,
// which with the elbow where its model has it is predicted 2.6 mrad wrong; half of it would tell.
TEST(LimbSimulator, NeighboursDoWhatTheyWereMeasuredToDo) {
  const auto model = nao::test::robot("nao_h21_v33");
  const Joint elbow = *cutLimbs(suspend(*model), {"RElbowRoll"}).findJoint("RElbowRoll");
  const RecordedLimb arm({"RShoulderPitch", "RElbowRoll"},
                         {{"torque_bias", {{"torque", 3}}, {elbow}, ""}});
  EXPECT_LT(arm.errorOf("RShoulderPitch", {})[0], 1.3e-3);
}

// Both thighs hang on one motor. Without the other leg the hip was predicted 0.46 mrad and 0.039 A
// wrong, twice what its six repeats tell; a limb that is stiff a joint too early leaves 0.21 and
// 0.012.
TEST(LimbSimulator, TurnsTheOtherLegByTheirCommonMotor) {
  const RecordedLimb leg({"LHipPitch"});
  const Eigen::RowVector2d error = leg.errorOf("LHipPitch", {});
  EXPECT_LT(error[0], 0.15e-3);
  EXPECT_LT(error[1], 6e-3);
}

// One starts late, one early by as much: what a mean of runs is late would be told as a delay.
TEST(LimbSimulator, StartsInTimeOnTheMean) {
  const JointNoise noise{0.03, 0.05, 1e-3, 0, 0};
  double sum = 0, square = 0;
  for (std::uint64_t stream = 0; stream < 48; ++stream) {
    const double late = drawLateness(noise, drawOf(stream, 2), 0.1);
    sum += late;
    square += late * late;
  }
  EXPECT_NEAR(sum, 0, 1e-12);
  EXPECT_NEAR(std::sqrt(square / 48), 1e-3, 3e-4);  // of 24 draws: two of its SDs
}

TEST(LimbSimulator, DrawsByStreamAlone) {
  const RecordedLimb arm({"RShoulderRoll"});
  const RigSimulator rig(arm.set, arm.joint("RShoulderRoll"));
  const JointNoise noise{0.03, 0.05, 1e-3, 0, 0};
  const EffectSetting idle{"coulomb_friction", {{"torque", 0}}, {}, ""};
  const auto run = [&](const std::vector<EffectSetting>& causes, std::uint64_t stream) {
    return rig.exact().run(causes, 0, stream, noise);
  };
  EXPECT_EQ(run({}, 3), run({}, 3));
  EXPECT_NE(run({}, 3), run({}, 4));
  EXPECT_LT((run({idle}, 3) - run({}, 3)).norm(), 1e-9);
}

// Of the variance of a mean of two runs pairs leave a twentieth (elbow, hip) to a sixth (shoulder,
// which rattles in its play), by rigs and by worlds: what noise does is nearly in proportion to it.
TEST(LimbSimulator, MirroredRunsKnowTheMeanBetter) {
  const RecordedLimb arm({"RElbowYaw"});
  const RigSimulator rig(arm.set, arm.joint("RElbowYaw"));
  const JointNoise noise{0.03, 0.05, 1e-3, 0, 0};
  const std::vector<EffectSetting> unrounded{
      {"encoder_quantum",
       {{"quantum", -rig.present("encoder_quantum", "quantum")}},
       rig.place(),
       ""}};
  const JointSimulator* const simulators[] = {&rig.coarse(), &rig.exact()};
  for (const JointSimulator* simulator : simulators) {
    const auto angle = [&](std::uint64_t stream) -> Eigen::VectorXd {
      return simulator->run(unrounded, 0, stream, noise).col(0);
    };
    double pairs = 0, others = 0;
    for (std::uint64_t at = 0; at < 64; at += 8) {
      pairs += (angle(at) + angle(at + 2) - angle(at + 4) - angle(at + 6)).squaredNorm();
      others += (angle(at) + angle(at + 1) - angle(at + 4) - angle(at + 5)).squaredNorm();
    }
    EXPECT_LT(pairs, 0.3 * others) << pairs / others;
  }
}

sim::HingeMotion swung(Duration step, int inertia_every) {
  const RobotModel robot = stripped(suspend(*nao::test::robot("nao_h21_v33")));
  const RobotModel leg = cutLimbOf(robot, "LKneePitch", JointArray<double>(robot.jointCount()));
  std::vector<JointCommand> orders;
  for (int k = 0; k < 200; ++k) {
    orders.push_back(
        {JointArray<double>(leg.jointCount()), JointArray<double>(leg.jointCount(), 1.0)});
    for (std::size_t j = 0; j < leg.jointCount(); ++j) {
      orders.back().angle[j] = 0.3 * (1 - std::cos(0.08 * k));
    }
  }
  sim::HingeRun run;
  run.step = step;
  run.inertia_every = inertia_every;
  return sim::runHinges(leg, {}, orders, run);
}

// To a joint it is a heavier rotor, and equal robots differ in both.
TEST(LimbSimulator, KnowsTheInertiaThatLinksHaveOfTheirOwn) {
  const RecordedLimb head({"HeadYaw"});
  const RigSimulator yaw(head.set, head.joint("HeadYaw"));
  const std::vector<Body>& bodies = head.model->bodies;
  const double rotor = head.model->actuators[index(head.joint("HeadYaw"))].rotor_inertia;
  const double expected = std::hypot(bodies[1].I_Bcm(2, 2), bodies[2].I_Bcm(2, 2)) / rotor;
  EXPECT_GT(expected, 0.3);
  EXPECT_NEAR(yaw.linkInertia(), expected, 1e-12);
  const auto& causes = jointCauses();
  const auto rotor_cause = std::find_if(causes.begin(), causes.end(),
                                        [](const Cause& one) { return one.id == "motor_inertia"; });
  ASSERT_NE(rotor_cause, causes.end());
  const Cause here = boundedAt(*rotor_cause, yaw, sim::standardEffects());
  EXPECT_NEAR(here.spread, rotor_cause->spread * std::hypot(1, expected), 1e-12);
}

// Swings of 1.3 Hz in all joints of a leg. An encoder's count is 1.5 mrad; a hundredth of it is
// less than any mean of repeats tells. Twice the time in between errs about four times as much.
TEST(LimbSimulator, ALegMovesTheSameByInertiaOfEveryMillisecond) {
  constexpr Duration kStep = std::chrono::microseconds(250);
  const Eigen::MatrixXd exact = swung(kStep, 1).q;
  const auto error = [&](int every) {
    return (swung(kStep, every).q - exact).cwiseAbs().maxCoeff();
  };
  const double by_1ms = error(inertiaEvery(kStep)), by_4ms = error(16);
  EXPECT_LT(by_1ms, 15e-6);
  EXPECT_GT(by_4ms, 4 * by_1ms);
}

// Coarse steps of 1 ms are 0.7 mrad late themselves, in every run alike; inertia of every other one
// adds a hundredth of a count at most.
TEST(LimbSimulator, ALegMovesTheSameByInertiaOfEveryOtherCoarseStep) {
  constexpr Duration kStep = std::chrono::milliseconds(1);
  const int every = inertiaEvery(kStep);
  EXPECT_EQ(every, 2);
  EXPECT_LT((swung(kStep, every).q - swung(kStep, 1).q).cwiseAbs().maxCoeff(), 15e-6);
}

TEST(LimbKeys, TellEffectsApartByJointAndByTheLastDigit) {
  const EffectSetting at_one{"torque_bias", {{"torque", 0.1}}, {toJoint(1)}, "here"};
  EffectSetting elsewhere = at_one, next = at_one, asked_elsewhere = at_one;
  elsewhere.joints = {toJoint(2)};
  next.parameters["torque"] = std::nextafter(0.1, 1);
  asked_elsewhere.place = "there";  // acts alike
  EXPECT_NE(keyOf({at_one}), keyOf({elsewhere}));
  EXPECT_NE(keyOf({at_one}), keyOf({next}));
  EXPECT_NE(keyOf({at_one}), keyOf({at_one, at_one}));
  EXPECT_EQ(keyOf({at_one}), keyOf({asked_elsewhere}));
}

}  // namespace
}  // namespace nao::validation
