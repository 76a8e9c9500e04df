#pragma once

#include <memory>

#include "core/latest.h"
#include "core/leds.h"
#include "core/mailbox.h"
#include "core/robot_io.h"
#include "motion/motion_request.h"
#include "motion/motion_state.h"

namespace nao::motion {

/// Where the thread of the simulation and the thread of the services meet, for one robot.
/// The robot drains `requests` and `leds`, reads `body`, and publishes the rest; services do the
/// opposite.
struct RobotPorts {
  Mailbox<MotionRequest> requests{1024};
  Mailbox<LedOrder> leds{1024};
  Latest<BodyCommand> body;  // of a program that drives past all motions; null: there never was one
  Mailbox<MotionOutcome> outcomes{8192};
  Latest<SensorFrame> sensors;
  Latest<MotionState> state;
  /// The frames that feel another touch than the one before: a short press lies between two looks
  /// at the newest. What no longer fits is lost.
  Mailbox<std::shared_ptr<const SensorFrame>> touches{256};

  void publish(std::shared_ptr<const SensorFrame> frame);
};

/// Whether both feel the same pressed: head, hands, chest button and bumpers.
bool feelTheSame(const SensorFrame& one, const SensorFrame& other);

}  // namespace nao::motion
