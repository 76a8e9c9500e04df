#pragma once

#include <string>
#include <vector>

#include "tests/hidden/mujoco/mujoco_robot.h"

namespace nao::hidden {

/// The robot as MuJoCo reads it. Hinges are called "rotor<c>" and "play<c>" by coordinate c: a
/// motor's rotor is a body of its own between parent and link, and the gear's play a hinge between
/// rotor and link whose range is as narrow as the play. What the link turns is the sum of the two.
/// Gears without play and hinges without a motor have no "play<c>". Joints of `stopped` meet the
/// stops at the ends of their range.
std::string writeMjcf(const MujocoRobot& robot, const std::vector<Joint>& stopped, double step);

}  // namespace nao::hidden
