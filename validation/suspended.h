#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "core/suspend.h"

namespace nao::validation {

/// What is left of a suspended robot if nothing may touch anything: no solids, soles or spheres.
/// The same motion of the joints at a lower cost, as long as the robot does not touch itself.
RobotModel stripped(const RobotModel& model);

/// Only the limbs that hold these joints; exact if the base is fixed, because nothing then passes
/// from limb to limb but by a motor that both share (HipYawPitch: both legs are kept). Frames,
/// sensors, ways and postures are left behind. @throws InputError for a robot whose base is free
/// or a name it does not have.
RobotModel cutLimbs(const RobotModel& model, const std::vector<std::string>& joints);

/// The limb of one joint, for what it feels of its neighbours. Of a limb that shares a motor with
/// it, whose weight and inertia that motor turns too, the first hinges are left, the rest as one
/// solid in `pose` [rad]. Errors as cutLimbs().
RobotModel cutLimbOf(const RobotModel& model, const std::string& joint,
                     const JointArray<double>& pose);

}  // namespace nao::validation
