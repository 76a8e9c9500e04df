#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "core/archive.h"
#include "core/leds.h"
#include "core/robot_io.h"
#include "core/sim_time.h"
#include "motion/motion_request.h"
#include "runtime/world_request.h"

namespace nao::runtime {

/// Something from outside that a simulation takes over at a moment of simulated time. All inputs in
/// their order, on the same start, give the same run to the last bit.
struct Input {
  enum class Place : std::uint8_t {
    Between,  // of two steps: a world request, or what is accepted while the world stands
    Cycle,    // in the robot's own cycle
  };
  using Content = std::variant<motion::MotionRequest, LedOrder, BodyCommand, WorldRequest>;

  SimTime time{};
  Place place = Place::Between;
  std::size_t robot = 0;  // of a world request: 0
  Content content;
};

/// What is asked for: "MoveTo", "LedOrder", "PushRobot".
std::string nameOf(const Input::Content& content);

/// Lists all of an input but its time, place and robot.
void archiveContent(Archive& archive, Input::Content& content);

/// Adds what an input is to a hash: its simulated time, robot and content; not how it was numbered.
void addTo(Archive& hash, const Input& input);

}  // namespace nao::runtime
