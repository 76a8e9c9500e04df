#pragma once

#include <map>
#include <string>

#include "core/robot_model.h"
#include "naoqi_api/memory/device_keys.h"

// Which keys a robot's devices have, and what they show. Names and units: NAOqi 2.1.4.13
// documentation, actuator_sensor_names.html; the short inertial names are those of NAOqi 1.x.
namespace nao::memory {

using Views = std::map<std::string, View>;

/// Angles [rad], currents [A], temperatures [deg C] and stiffness of every motor. Position/Sensor
/// is the encoder on the motor's side of the gear: within the gear's play it follows the motor,
/// not the limb. Temperature/Sensor/Status says how far the board holds back, 0 not at all to 3.
void addJointViews(const RobotModel& model, Views& views);

/// ALMotion's own keys, Motion/<what>/<Sensor|Command>/<joint>, and whether it is awake or fell.
void addMotionViews(const RobotModel& model, Views& views);

/// Accelerometer [m/s^2], gyroscope [rad/s] and the torso's angles [rad], by old and new names.
void addInertialViews(Views& views);

/// Force sensors [kg], centres of pressure [m], bumpers and contact of the feet.
void addFootViews(const RobotModel& model, Views& views);

/// Sonar [m], battery (charge 0 to 1, current [A], temperature [deg C]), chest button, tactile
/// sensors of head and hands, each with its event.
void addBoardViews(const RobotModel& model, Views& views);

/// How bright each light is, 0 to 1.
void addLedViews(const RobotModel& model, Views& views);

}  // namespace nao::memory
