#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/frames.h"

namespace nao::motion {

/// Which feet a whole-body call speaks of: "Legs", "LLeg", "RLeg".
enum class Feet : std::uint8_t { Both, Left, Right };

/// How a foot stands: where it is, anywhere on the floor it stands on, or not at all.
enum class FootState : std::uint8_t { Fixed, Plane, Free };

struct WbEnable {
  bool on = true;
};
struct WbFootState {
  FootState state = FootState::Fixed;
  Feet feet = Feet::Both;
};
/// Keeps the centre of mass over the feet, as commanded.
struct WbBalance {
  bool on = true;
  Feet feet = Feet::Both;
};
/// Brings the centre of mass over the middle of the feet; books the legs.
struct WbGoToBalance {
  Feet feet = Feet::Both;
  double seconds = 1;
};
/// An effector (Head, LArm, RArm) led by targets; the whole body helps.
struct WbEffector {
  std::string chain;
  bool on = true;
};
/// In the robot frame of the moment control was given: turns about x, y, z [rad] for Head, a place
/// [m] for an arm.
struct WbEffectorTarget {
  std::string chain;
  Vec3 target = Vec3::Zero();
};
/// While active an effector keeps its place over the feet, however the body moves.
struct WbOptimize {
  std::string chain;
  bool on = true;
};

}  // namespace nao::motion
