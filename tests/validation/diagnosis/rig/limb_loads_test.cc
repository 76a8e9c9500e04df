#include "validation/diagnosis/rig/limb_loads.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "tests/support/models.h"
#include "validation/diagnosis/rig/rig_simulator.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

const JointNoise kNoise{0.1, 0.05, 0, 0, 0};

// A left arm that turns for two seconds.
class ArmLoads : public testing::Test {
 protected:
  ArmLoads() {
    model_ = std::make_shared<RobotModel>(
        cutLimbs(stripped(suspend(*nao::test::robot("nao_h21_v33"))), {"LElbowRoll"}));
    RecordingPlan plan;
    plan.model = model_;
    plan.motions = standardRecording(model_);
    plan.motions.resize(1);
    plan.motions[0].duration = 2;
    plan.repeats = 1;
    set_ = std::make_shared<RigSet>(recordSimulated(plan), model_);
    shoulder_ = *model_->findJoint("LShoulderRoll");
    limb_ = std::make_shared<Limb>(*set_, shoulder_);
    loads_ = std::make_unique<LimbLoads>(limb_, std::chrono::milliseconds(1), 5);
  }
  std::vector<EffectSetting> heavier(double part) const {
    return {{"link_mass", {{"part", part}}, {shoulder_}, ""}};
  }

  std::shared_ptr<RobotModel> model_;
  std::shared_ptr<const RigSet> set_;
  Joint shoulder_{};
  std::shared_ptr<const Limb> limb_;
  std::unique_ptr<LimbLoads> loads_;
};

double between(const std::vector<double>& a, const std::vector<double>& b) {
  using Values = Eigen::Map<const Eigen::VectorXd>;
  const auto size = static_cast<Eigen::Index>(a.size());
  return (Values(a.data(), size) - Values(b.data(), size)).norm();
}

TEST_F(ArmLoads, AreRememberedForMuchTheSameNoise) {
  JointNoise more = kNoise;
  more.torque_sd *= 1.03;
  more.torque_time *= 2;  // the joint's own
  const auto load = loads_->get(0, {}, {}, 1, kNoise);
  EXPECT_EQ(loads_->get(0, {}, {}, 1, more), load);
  more.torque_sd *= 2;
  EXPECT_NE(loads_->get(0, {}, {}, 1, more), load);
  EXPECT_NE(loads_->get(0, {}, {}, 2, kNoise), load);
}

// What a joint that sticks and slips scatters by says nothing about its neighbours.
TEST_F(ArmLoads, NeighboursAreShakenByNoMoreThanRobotsAre) {
  JointNoise loud = kNoise;
  loud.torque_sd = 5;
  for (const EffectSetting& shaken : limb_->disturbances(loud)) {
    EXPECT_LE(shaken.parameters.at("sd"), shaken.joints[0] == limb_->joint() ? 5 : 4 * 0.03);
  }
}

// Twice as heavy a link weighs along the motion without what it weighs along its own, where the arm
// sags further: to a tenth of the difference that it makes.
TEST_F(ArmLoads, AlongTheMotionWithoutAMassAreWhatTheyAreAlongItsOwn) {
  const auto without = loads_->get(0, {}, {}, 0, {});
  const auto along = loads_->get(0, heavier(1), {}, 0, {});
  const auto own = loads_->get(0, heavier(1), heavier(1), 0, {});
  EXPECT_EQ(along->reference, without->reference);
  EXPECT_NE(own->reference, without->reference);
  for (const auto values : {&sim::JointLoad::torque, &sim::JointLoad::inertia}) {
    const double change = between((*own).*values, (*without).*values);
    EXPECT_GT(change, 0);
    EXPECT_LT(between((*along).*values, (*own).*values), 0.1 * change);
  }
}

}  // namespace
}  // namespace nao::validation
