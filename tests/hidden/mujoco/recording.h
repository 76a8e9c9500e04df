#pragma once

#include "validation/log/simulated_recording.h"

namespace nao::hidden {

/// Whether this build has MuJoCo (scripts/setup installs it).
bool hasMujoco();

/// As validation::recordSimulated, but the reality is MuJoCo's (mujoco_robot.h), at steps of 0.5
/// ms. The robot must have a fixed base; effects are those of makeMujocoRobot(). Angles alone are
/// written. Left out: contact of the robot with itself, coupled limits (orders are clipped to
/// them), and stops of joints that are not written; the motions come to none of these.
/// @throws InputError without MuJoCo.
validation::LogSet recordMujoco(const validation::RecordingPlan& plan);

}  // namespace nao::hidden
