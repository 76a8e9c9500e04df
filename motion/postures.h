#pragma once

#include <memory>
#include <string>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/phase.h"

namespace nao::motion {

/// Whether the commanded legs are within reach of a posture's, so that a straight way between
/// the two is short.
bool legsAreNear(const RobotModel& model, const JointArray<double>& angle, const Posture& posture);

/// Whether the robot is measured to be in this posture: joints, and the torso upright, on its
/// back or on its belly as the posture's family says.
bool isIn(const RobotModel& model, const SensorFrame& measured, const Posture& posture);

/// The posture the robot is in, or null when it is in none of the robot's file.
const Posture* findCurrentPosture(const RobotModel& model, const SensorFrame& measured);

/// The family of the current posture ("Standing"); in no posture, what the torso's angle allows
/// to say ("LyingBack"), else "Unknown".
std::string currentFamily(const RobotModel& model, const SensorFrame& measured);

/// A way to `posture` at `fraction` of the speed a standing robot bears.
std::unique_ptr<Phase> glideTo(const RobotModel& model, const Posture& posture, double fraction);

/// As glideTo, by way of other postures where the straight way would throw the robot over; fails
/// if the robot does not get there. `target` must outlive the phase.
std::unique_ptr<Phase> goToPosture(const RobotModel& model, const Posture& target, double fraction);

/// Stiffness on, and up from Crouch to StandInit.
std::unique_ptr<Phase> wakeUp(const RobotModel& model);

/// To Crouch if the robot is on its feet, then stiffness off.
std::unique_ptr<Phase> rest(const RobotModel& model);

}  // namespace nao::motion
