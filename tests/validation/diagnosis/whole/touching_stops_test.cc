#include "validation/diagnosis/whole/touching_stops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/suspend.h"
#include "tests/support/models.h"
#include "validation/diagnosis/whole/whole_fit.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

constexpr double kSlope = -0.6, kPlace = -0.75;  // [rad/rad], [rad]

// A hull's lower edge of a hanging ankle, which that joint's slow sweep meets; nothing else is.
class StoppedAnkle : public testing::Test {
 protected:
  // `beside`: the middle of its roll's sweep [rad].
  LogSet record(double place, double beside) const {
    RecordingPlan plan;
    plan.model = model_;
    plan.joints = {"LAnklePitch", "LAnkleRoll"};
    plan.motions = {standardRecording(model_)[1]};
    moveOnly(plan.joints, model_, plan.motions);
    plan.motions[0].angles = [all = plan.motions[0].angles,
                              pitch = *model_->findJoint("LAnklePitch"),
                              roll = *model_->findJoint("LAnkleRoll"), beside](double t) {
      JointArray<double> angle = all(t);
      angle[pitch] = -0.6 - 0.3 * std::sin(2 * t);
      angle[roll] = beside - 0.09 * std::sin(3 * t);
      return angle;
    };
    plan.repeats = 3;
    plan.extra = {{"coupled_stop",
                   {{"upper", 0}, {"lower", kSlope}, {"place", place}},
                   {*model_->findJoint("LAnkleRoll")},
                   ""}};
    return recordSimulated(plan);
  }

  std::shared_ptr<const RobotModel> model_ =
      std::make_shared<RobotModel>(suspend(*test::robot("nao_h21_v33_no_hull")));
  WholeSimulator simulator_{record(kPlace, -0.3), model_};
};

// The slopes of the row are a third apart, so that one is within a sixth of the hidden one: over
// the 0.15 rad by which that stop moves here a line of it is off by a sixth of 0.09 rad at most,
// and by some counts of 1.5 mrad.
TEST_F(StoppedAnkle, TouchesWhereTheHiddenStopWas) {
  std::vector<PlacedCause> causes = limbCauses(*model_, "LLeg", simulator_.joints());
  const auto stop = std::find_if(causes.begin(), causes.end(), [](const PlacedCause& one) {
    return one.cause.id == "coupled_stop.lower" && one.place == "LAnkleRoll";
  });
  ASSERT_NE(stop, causes.end());
  startWhereTouched(*stop, simulator_);
  double nearest = 10, inside = 10;
  for (const std::vector<double>& line : startsOf(stop->cause)) {
    const double turned = std::log(line[0] / kSlope);
    if (std::isnan(turned) || std::abs(turned) > nearest) continue;
    nearest = std::abs(turned);
    // Where the ankle was bent most, by which a stop goes as far inside as anywhere.
    inside = line[0] * (-0.9 - line[1]) - kSlope * (-0.9 - kPlace);
  }
  EXPECT_LT(nearest, 0.16);
  EXPECT_NEAR(inside, 0, 0.02);
}

// What a slope moves is where the line is met, 0.9 rad from its place: it changes what a place
// does, by how far that is over the slope. Steps by which the line left the sweep's end for good
// said 15 % less, and that the two make up for each other by 12 % less than they do.
TEST_F(StoppedAnkle, TurnsAboutItsPlace) {
  const WholeSimulator simulator(record(0, 0.2), model_);
  std::vector<PlacedCause> causes;
  for (const PlacedCause& one : limbCauses(*model_, "LLeg", simulator.joints())) {
    if (one.cause.id == "coupled_stop.lower" && one.place == "LAnkleRoll") causes.push_back(one);
  }
  WholeData data(simulator, simulator.joints(), false);
  const WholeTask task{&data, &causes, {}, {}, 1};
  WholeFit fit;
  fit.model = {{0, {kSlope, 0}}};
  addJacobian(task, fit);
  const Eigen::VectorXd slope = fit.jacobian.col(0), place = fit.jacobian.col(1);
  const double along = slope.dot(place) / place.squaredNorm();
  EXPECT_NEAR(along, 0.9 / kSlope, 0.05);
  EXPECT_LT((slope - along * place).norm(), 0.05 * slope.norm());
}

}  // namespace
}  // namespace nao::validation
