#include "core/suspend.h"

namespace nao {

RobotModel suspend(const RobotModel& model) {
  constexpr double kLift = 1;  // [m] more than any limb of a Nao is long
  RobotModel hung = model;
  if (!model.fixed_base) hung.bodies[0].X_PB.translation().z() += kLift;
  hung.fixed_base = true;
  return hung;
}

}  // namespace nao
