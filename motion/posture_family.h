#pragma once

#include <string>

#include "core/robot_io.h"
#include "core/robot_model.h"

namespace nao::motion {

/// Which way is up, in the torso frame: a unit vector from the fused angles of the inertial unit.
Vec3 upInTorso(const SensorFrame& measured);

/// The torso's pitch [rad] in (-pi, pi]: 0 upright, pi/2 face down, -pi/2 on its back.
double torsoPitch(const SensorFrame& measured);

/// How the body rests on the ground, from joint angles and torso angles: "LyingBack",
/// "LyingBelly", "LyingLeft", "LyingRight" by the torso alone; for a Nao whose torso is upright
/// "Standing", "Crouching", "Sitting" or "Knee" by where hips, knees and soles then are. Else
/// "Unknown".
std::string bodyFamily(const RobotModel& model, const SensorFrame& measured);

}  // namespace nao::motion
