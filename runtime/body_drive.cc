#include "runtime/body_drive.h"

#include <cmath>

#include "motion/limits.h"

namespace nao::runtime {

bool BodyDrive::update(const BodyCommand* newest, SimTime now) {
  if (newest && newest->number != seen_) {
    seen_ = newest->number;
    state_ = {true, now, newest->angle, newest->stiffness, {}};
    return true;
  }
  if (now - state_.heard >= kHold) release();
  return false;
}

const JointCommand& BodyDrive::drive(const RobotModel& model, const SensorFrame& measured) {
  JointCommand& given = state_.given;
  given = {state_.angle, state_.stiffness};
  motion::JointSet asked;
  for (std::size_t i = 0; i < given.angle.size(); ++i) {
    asked.set(i, !std::isnan(given.angle[i]));
    if (!asked.test(i)) given.angle[i] = measured.angle[i];
  }
  motion::clipToLimits(model, asked, given.angle);
  return given;
}

void BodyDrive::addTo(Archive& hash) const {
  bool drives = state_.drives;
  hash.value(drives);
  if (!drives) return;
  State state = state_;
  hash.value(state.heard);
  hash.value(state.angle);
  hash.value(state.stiffness);
}

}  // namespace nao::runtime
