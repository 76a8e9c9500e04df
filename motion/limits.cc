#include "motion/limits.h"

#include <algorithm>

namespace nao::motion {

void clipToLimits(const RobotModel& model, const JointSet& joints, JointArray<double>& angle) {
  for (std::size_t i = 0; i < model.jointCount(); ++i) {
    const Actuator& actuator = model.actuators[i];
    if (joints.test(i)) angle[i] = std::clamp(angle[i], actuator.lower, actuator.upper);
  }
  for (const CoupledLimit& limit : model.coupled_limits) {
    if (!limit.clip || !joints.test(index(limit.limited))) continue;
    const auto [low, high] = limit.rangeAt(angle[limit.driver]);
    angle[limit.limited] = std::clamp(angle[limit.limited], low, high);
  }
}

}  // namespace nao::motion
