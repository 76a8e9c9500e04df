#pragma once

#include "core/latest.h"
#include "core/leds.h"
#include "core/mailbox.h"
#include "core/robot_io.h"
#include "motion/motion_request.h"
#include "motion/motion_state.h"

namespace nao::motion {

/// Where the thread of the simulation and the thread of the services meet, for one robot.
/// The robot drains `requests` and `leds`, and publishes the rest; services do the opposite.
struct RobotPorts {
  Mailbox<MotionRequest> requests{1024};
  Mailbox<LedOrder> leds{1024};
  Mailbox<MotionOutcome> outcomes{8192};
  Latest<SensorFrame> sensors;
  Latest<MotionState> state;
};

}  // namespace nao::motion
