#pragma once

#include <vector>

#include "core/frames.h"
#include "core/robot_model.h"

namespace nao::runtime {

/// Where frame R of a robot really is: between its soles, heading as they do on average. For a
/// robot without feet, below its root. `X_WB` is by body of the model.
Pose2 calcFloorPose(const RobotModel& model, const std::vector<Pose>& X_WB);

}  // namespace nao::runtime
