#pragma once

#include <vector>

#include "core/world_model.h"
#include "sim/ball_body.h"
#include "sim/contact_report.h"
#include "sim/robot_body.h"

namespace nao::sim {

/// What is around a robot, for the sensors that see or feel it. References into a World, for the
/// length of a call.
struct Surroundings {
  const WorldModel& world;
  const std::vector<RobotBody*>& robots;
  const std::vector<BallState>& balls;
  const ContactReport& contacts;
  std::size_t self;  // index of the robot that senses
};

}  // namespace nao::sim
