#include "validation/diagnosis/replay/replay_start.h"

#include <algorithm>
#include <cmath>

#include "validation/merge_effects.h"

namespace nao::validation {

JointArray<double> startAngles(const RobotModel& robot, const WholeRun& measured,
                               const sim::EffectCatalogue& catalogue, Random* random) {
  constexpr double kPushes = 0.003;  // [rad] of error: two counts of a Nao's encoder
  JointArray<double> angle(robot.jointCount());
  for (std::size_t j = 0; j < robot.jointCount(); ++j) {
    const auto column = static_cast<Eigen::Index>(j);
    angle[j] = measured.command(0, column);
    const double reported = measured.angle(0, column);
    if (reported == 0) continue;
    const double play = presentDeviation(robot, j, "backlash", "width", catalogue);
    const double side = std::clamp((angle[j] - reported) / kPushes, -1.0, 1.0);
    const double unknown = random ? (1 - std::abs(side)) * random->uniform(-1, 1) : 0;
    angle[j] = reported - (side + unknown) * play / 2;
  }
  return angle;
}

}  // namespace nao::validation
