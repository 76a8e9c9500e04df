#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "core/frames.h"
#include "core/joint.h"
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
/// A motor that gives no torque; as in sim/faults.h, like the next two.
struct KillJoint {
  std::size_t robot = 0;
  Joint joint{};
  Duration duration{};
};
/// A sensor that goes on to report what it reports now.
struct FreezeSensor {
  std::size_t robot = 0;
  std::string sensor;
  Duration duration{};
};
/// A sensor with white noise on top.
struct DisturbSensor {
  std::size_t robot = 0;
  std::string sensor;
  double sd = 0;  // in the sensor's unit
  Duration duration{};
};
struct HeatMotor {
  std::size_t robot = 0;
  Joint joint{};
  double temperature = 0;  // [deg C] from now on, until it cools
};
struct SetCharge {
  std::size_t robot = 0;
  double charge = 0;  // of the battery, 0 to 1
};
struct DirtyLens {
  std::size_t robot = 0;
  std::size_t camera = 0;  // index into RobotModel::cameras
  double dirt = 0;         // 0 clean to 1 blind
};
/// A round patch of the ground on which soles hold less.
struct WetFloor {
  double x = 0, y = 0;  // [m] in W
  double radius = 0;    // [m]
  double friction = 0;  // Coulomb coefficient
  Duration duration{};
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
using WorldRequest =
    std::variant<PushRobot, PressSensor, PlaceRobot, PlaceBall, ResetWorld, TakeSnapshot,
                 RestoreSnapshot, DropSnapshot, KillJoint, FreezeSensor, DisturbSensor, HeatMotor,
                 SetCharge, DirtyLens, WetFloor>;

}  // namespace nao::runtime
