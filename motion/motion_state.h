#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "core/sim_time.h"
#include "motion/collision_guard.h"
#include "motion/motion_request.h"

namespace nao::motion {

/// A booked task, as ALMotion.getTaskList shows it.
struct Task {
  std::string name;
  RequestId id = 0;
  std::vector<Joint> joints;
};

/// Why calls fail that wait while the robot is set back.
inline constexpr char kSetBackReason[] = "the simulation was set back to a snapshot";

/// What the motion engine has commanded, published once per tick. What services may read.
struct MotionState {
  SimTime time{};
  RequestId last_accepted = 0;  // every request up to here has taken effect
  JointCommand command;
  JointArray<double> stiffness;  // asked for; smart stiffness may command less
  bool driven = false;           // by a program past all motions: command and stiffness are its own
  bool awake = false;
  bool move_active = false;
  std::uint64_t moves_failed = 0;  // how many moves were refused, or ended before they should
  bool failed_under_way = false;   // the last of these had begun
  Pose2 position;                  // odometry, frame R
  Pose2 next_position;
  Velocity2 velocity;
  std::vector<Footstep> footsteps;
  std::vector<Task> tasks;
  bool falling = false;
  bool fallen = false;
  std::array<Nearness, CollisionGuard::kArms> arms{};  // left, right: to the rest of the body
  std::uint64_t set_back = 0;  // how often the robot was set back to an earlier state; calls that
                               // wait over that have failed
};

}  // namespace nao::motion
