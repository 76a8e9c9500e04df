#pragma once

#include <string>

#include "core/config.h"
#include "core/robot_model.h"
#include "core/robot_model_urdf.h"

namespace nao {

// The files of a robot's folder, one reader each. All throw InputError with file and line.

/// body.yaml: what a URDF can not say. Fills everything but postures and cameras.
void readBody(const std::string& file, const UrdfRobot& urdf, RobotModel& model);

/// The `drives` and `actuators` of body.yaml, and with them the coordinates and aliases.
void readActuators(Config& body, const UrdfRobot& urdf, RobotModel& model);

/// The list at `key`: `- {effect: name, joints: [names or groups], parameter: number, ...}`.
std::vector<EffectSetting> readEffects(Config& body, const std::string& key,
                                       const RobotModel& model);

/// postures.yaml; every posture gives every actuator an angle within its range.
void readPostures(const std::string& file, RobotModel& model);

/// cameras.yaml; each camera is a frame of the model as well.
void readCameras(const std::string& file, RobotModel& model);

/// The inertia tensor nearest to this one that obeys the triangle inequality, as a solid's does.
Mat3 nearestSolid(const Mat3& inertia);

/// Throws InputError unless every body could exist: mass above zero, inertia positive definite
/// and obeying the triangle inequality. A body 0 that is bolted down may be without mass.
void checkBodies(const UrdfRobot& urdf, const RobotModel& model);

/// The joint or body named at `key`, else an InputError.
Joint jointAt(Config& config, const std::string& key, const RobotModel& model);
int bodyAt(Config& config, const std::string& key, const RobotModel& model);

}  // namespace nao
