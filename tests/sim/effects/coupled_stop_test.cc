#include "sim/effects/coupled_stop.h"

#include <gtest/gtest.h>

#include "sim/effects/catalogue.h"
#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

BodyPlan planWith(const RobotModel& model, const std::vector<EffectSetting>& effects) {
  WorldModel world;
  BodyPlan plan(model, world);
  EffectChain chain = chainOf(model, effects);
  chain.alterPlan(plan);
  return plan;
}

// The range that all coupled limits leave to `limited` while `driver` is at this angle.
std::pair<double, double> rangeAt(const BodyPlan& plan, Joint limited, double angle) {
  const int hinge = plan.model.actuators[index(limited)].coordinates[0];
  const Coordinate& c = plan.model.coordinates[static_cast<std::size_t>(hinge)];
  std::pair<double, double> range{c.lower, c.upper};
  for (const CoupledLimit& limit : plan.model.coupled_limits) {
    if (limit.limited != limited) continue;
    const auto [low, high] = limit.rangeAt(angle);
    range = {std::max(range.first, low), std::min(range.second, high)};
  }
  return range;
}

class CoupledStop : public testing::Test {
 protected:
  std::shared_ptr<const RobotModel> model_ = nao::test::robot("nao_h21_v33_ideal");
  Joint roll_ = *model_->findJoint("LAnkleRoll"), pitch_ = *model_->findJoint("LAnklePitch");
  Joint knee_ = *model_->findJoint("LKneePitch"), hip_ = *model_->findJoint("LHipPitch");
  EffectSetting stopOf(Joint joint, std::map<std::string, double> parameters) const {
    return {"coupled_stop", std::move(parameters), {joint}, ""};
  }
};

TEST_F(CoupledStop, FollowsTheDriverOfALimitOrTheJointItHangsOn) {
  EXPECT_EQ(findCoupledTo(*model_, roll_), pitch_);
  EXPECT_EQ(findCoupledTo(*model_, knee_), hip_);
  EXPECT_EQ(findCoupledTo(*model_, *model_->findJoint("HeadYaw")), std::nullopt);
}

TEST_F(CoupledStop, ComesInBeyondItsPlaceAtItsSlope) {
  const auto free = rangeAt(planWith(*model_, {}), knee_, 0);
  const BodyPlan above = planWith(*model_, {stopOf(knee_, {{"upper", 0.5}, {"place", 0.2}})});
  EXPECT_DOUBLE_EQ(rangeAt(above, knee_, 0.1).second, free.second);
  EXPECT_NEAR(rangeAt(above, knee_, 0.6).second, free.second - 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(rangeAt(above, knee_, 0.6).first, free.first);
  const BodyPlan below =
      planWith(*model_, {stopOf(knee_, {{"upper", 0}, {"lower", -2}, {"place", -0.1}})});
  EXPECT_DOUBLE_EQ(rangeAt(below, knee_, 0).first, free.first);
  EXPECT_NEAR(rangeAt(below, knee_, -0.3).first, free.first + 0.4, 1e-12);
}

TEST_F(CoupledStop, LeavesTheModelsOwnLimitsInPlace) {
  const BodyPlan own = planWith(*model_, {});
  const BodyPlan both = planWith(*model_, {stopOf(roll_, {{"upper", -0.4}, {"place", -0.5}})});
  EXPECT_EQ(rangeAt(both, roll_, 0), rangeAt(own, roll_, 0));
  for (const double bent : {-0.6, -0.9, -1.1}) {
    const double hinge_upper = rangeAt(own, roll_, -0.5).second;
    const auto [low, high] = rangeAt(own, roll_, bent);
    EXPECT_LE(rangeAt(both, roll_, bent).second, high);
    EXPECT_LE(rangeAt(both, roll_, bent).second, hinge_upper + 1e-12);
    EXPECT_DOUBLE_EQ(rangeAt(both, roll_, bent).first, low);
  }
}

}  // namespace
}  // namespace nao::sim::test
