#include "validation/posture_trial.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "motion/postures.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr double kDegree = M_PI / 180;
constexpr double kSpeed = 0.8;         // of top speed, where no way has times of its own
constexpr Duration kGivingUp = 90s;    // of one try; no route of ways takes half of it
constexpr Duration kStaying = 1s;      // what stands for so long does not fall by itself
constexpr Duration kPush = 400ms;      // with 45 N an impulse of 18 Ns: 3.6 m/s if nothing held it
constexpr Duration kFalling = 2500ms;  // to the ground and at rest

}  // namespace

PostureTrial::PostureTrial(const ExperimentSettings& settings, std::uint64_t seed)
    : trial_(settings, seed, withSpread(*loadRobot(settings), {})) {
  trial_.standUp();
}

Arrival PostureTrial::goTo(const std::string& posture, int tries) {
  Arrival arrival;
  const SimTime start = trial_.now();
  while (!arrival.said && arrival.tries < tries) {
    ++arrival.tries;
    const auto outcome =
        trial_.waitFor(trial_.ask(motion::GoToPosture{posture, kSpeed}), kGivingUp);
    arrival.said = outcome && outcome->kind == motion::MotionOutcome::Kind::Done;
  }
  arrival.seconds = toSeconds(trial_.now() - start);
  const bool there = isReallyIn(posture);
  trial_.wait(kStaying);
  arrival.there = there && isReallyIn(posture);
  arrival.tilt_deg = calcTilt() / kDegree;
  return arrival;
}

void PostureTrial::knockOver(double newton_x, double newton_y) {
  const Eigen::Rotation2Dd heading(trial_.here().truth.theta);
  const Eigen::Vector2d force = heading * Eigen::Vector2d(newton_x, newton_y);
  trial_.simulation().world().push(0, {force.x(), force.y(), 0}, kPush);
  trial_.wait(kPush + kFalling);
  motion::SetStiffness stiff;
  for (std::size_t j = 0; j < trial_.model().jointCount(); ++j) {
    stiff.joints.push_back(static_cast<Joint>(j));
    stiff.stiffness.push_back(1);
  }
  trial_.ask(stiff);
  trial_.wait(500ms);
}

bool PostureTrial::isReallyIn(const std::string& posture) {
  const Posture* target = trial_.model().findPosture(posture);
  NAO_CHECK(target != nullptr);
  SensorFrame truth = *trial_.simulation().robot(0).ports()->sensors.get();
  const SceneFrame::Robot robot = trial_.simulation().world().scene().robots[0];
  for (std::size_t j = 0; j < trial_.model().jointCount(); ++j) {
    if (trial_.model().actuators[j].coordinates.empty()) continue;
    truth.angle[j] = calcHingeAngle(robot, static_cast<Joint>(j));
  }
  const Vec3 up_T = robot.X_WB[0].linear().row(2);
  truth.angle_x = std::atan2(up_T.y(), up_T.z());
  truth.angle_y = -std::asin(std::clamp(up_T.x(), -1.0, 1.0));
  return motion::isIn(trial_.model(), truth, *target);
}

double PostureTrial::calcTilt() {
  return std::acos(std::clamp(trial_.bodies().front().linear()(2, 2), -1.0, 1.0));
}

}  // namespace nao::validation
