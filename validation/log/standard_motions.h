#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// One of the motions that `record --protocol standard` plays, and what its runs are for.
struct StandardMotion {
  std::string name;
  Split split = Split::Fit;
};

inline constexpr double kStandardMotionTime = 6;  // [s] of one run
inline constexpr int kStandardRepeats = 6;        // runs of one motion

/// The motions of the standard set, for a robot whose torso is held and whose feet are in the air.
/// Every motion moves every joint, each at its own pace, so that no two joints move alike:
///   triangles  fit     slow ramps from end to end: friction, play, ends of the ranges
///   tones      fit     two sines: gains, inertia, delays
///   reach      fit     to both ends of the range and a hold there: stops, coupled limits, sag
///   stairs     fit     fast ramps and small steps with holds: torque limit, creep, overshoot
///   varied     select  a third of each: ramp and hold, two sines, sweep
///   crossing   test    ramps and stairs of other paces
///   quick      test    four sines of higher frequency under a slow one
const std::vector<StandardMotion>& standardMotions();

/// What every actuator is told [rad] `t` seconds after the motion began; before 0 and after
/// kStandardMotionTime the pose between motions, standardRest(). Hands stay at 0. Commands stay
/// inside joint ranges and coupled limits by a margin, below the joints' top speeds but for steps
/// of 0.06 rad, and the robot does not touch itself. A joint that the table of safe ranges (in the
/// .cc) does not name moves in the middle half of its range.
JointArray<double> standardAngles(const RobotModel& model, std::size_t motion, double t);

/// The pose in which every motion begins and ends, and what a run's `start_pose` says of it.
inline constexpr const char* kStandardRestPose = "rest of the standard motions";
JointArray<double> standardRest(const RobotModel& model);

/// What a run's `start_pose` means for this robot [rad]: the above, or a posture of its file
/// (empty: the one that it starts in). Nothing if it has no posture of that name.
std::optional<JointArray<double>> startPose(const RobotModel& model, const std::string& name);

/// For joints that nobody measured where there is none: `where` has that name. @throws InputError
[[noreturn]] void rejectStartPose(const RobotModel& model, const std::string& where,
                                  const std::string& name);

}  // namespace nao::validation
