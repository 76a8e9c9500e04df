#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/frames.h"
#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// One motion of the standing or walking protocol, begun in StandInit.
struct FloorMotion {
  std::string name;
  Split split = Split::Fit;
  double duration = 0;        // [s] recorded
  std::optional<Pose2> walk;  // walks there, in R; else joints move, calcFloorAngles()
};

/// `record --protocol stand`: both feet stay where they are, the torso upright.
///   squat       fit     down and up, slowly
///   sway        fit     from foot to foot
///   arms        fit     the arms swing, the legs hold
///   squat_fast  select  down and up, fast, with holds
///   mixed       test    squats while it sways
const std::vector<FloorMotion>& standingMotions();

/// `record --protocol walk`: forward, to the side and on the spot for fit; a curve for select; the
/// other turn and a diagonal for test.
const std::vector<FloorMotion>& walkingMotions();

/// What every actuator is told [rad] `t` seconds into a standing motion; before and after it, and
/// in a walk, StandInit. @throws InputError if the robot has no such posture.
JointArray<double> calcFloorAngles(const RobotModel& model, const FloorMotion& motion, double t);

}  // namespace nao::validation
