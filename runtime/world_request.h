#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/frames.h"
#include "core/sim_time.h"

namespace nao::runtime {

struct PushRobot {
  std::size_t robot = 0;
  Vec3 force_W = Vec3::Zero();  // [N] on the torso
  Duration duration{};
};
/// A finger on a bumper, tactile sensor or button, by NaoQi's device name ("Head/Touch/Front").
struct PressSensor {
  std::size_t robot = 0;
  std::string sensor;
  Duration duration{};
};
struct PlaceRobot {
  std::size_t robot = 0;
  Pose2 pose;
};
struct PlaceBall {
  std::size_t ball = 0;
  Vec3 p_W = Vec3::Zero();  // [m]
  Vec3 v_W = Vec3::Zero();  // [m/s]
};
/// Everything back to how it began; simulated time goes on.
struct ResetWorld {};

/// Keeps the present state under a name, in place of one that had this name.
struct TakeSnapshot {
  std::string name;
};
/// Everything back to that state, time too; motion requests under way fail.
struct RestoreSnapshot {
  std::string name;
};
struct DropSnapshot {
  std::string name;
};

/// What changes the world from outside: the simulator's user, never a NaoQi service.
using WorldRequest = std::variant<PushRobot, PressSensor, PlaceRobot, PlaceBall, ResetWorld,
                                  TakeSnapshot, RestoreSnapshot, DropSnapshot>;

}  // namespace nao::runtime
