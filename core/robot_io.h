#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "core/frames.h"
#include "core/joint.h"
#include "core/leds.h"
#include "core/sim_time.h"

namespace nao {

/// What the motion side asks of the body, once per control cycle.
struct JointCommand {
  JointArray<double> angle;      // [rad]; hands: 0 closed to 1 open
  JointArray<double> stiffness;  // 0 limp to 1 full torque; negative: motor off
};

/// What a program asks of the body itself, past the motion side, as LoLA does. Whole: what it did
/// not mention last is as it was.
struct BodyCommand {
  std::uint64_t number = 0;      // another one for every command of a robot
  JointArray<double> angle;      // [rad]; NaN: never asked for
  JointArray<double> stiffness;  // as in JointCommand
};

/// The two feet of a biped, where arrays are indexed by foot.
enum class Foot : std::uint8_t { Left = 0, Right = 1 };
constexpr std::size_t index(Foot foot) { return static_cast<std::size_t>(foot); }

/// The force sensors under one foot.
struct FootForces {
  std::array<double, 4> force{};  // [N] front left, front right, rear left, rear right
  double total = 0;               // [N] sum of the four
  double cop_x = 0;               // [m] centre of pressure in the ankle frame; 0 without load
  double cop_y = 0;               // [m]
  std::array<bool, 2> bumper{};   // left, right
};

/// Where a robot can be touched or pressed.
struct TouchState {
  std::array<bool, 3> head{};                 // front, middle, rear
  std::array<std::array<bool, 3>, 2> hand{};  // left hand, right hand: left, back, right
  bool chest_button = false;
};

/// One ultrasonic receiver: distances of up to ten echoes, nearest first.
inline constexpr std::size_t kSonarEchoes = 10;
using SonarEchoes = std::array<double, kSonarEchoes>;  // [m]; 0: no sonar

struct BatteryState {
  double charge = 1;        // 0 to 1
  double current = 0;       // [A] below zero while it gives
  double voltage = 0;       // [V]
  double temperature = 25;  // [deg C]
};

/// What the body reports, once per control cycle: measured values, never the ground truth.
struct SensorFrame {
  SimTime time{};
  JointArray<double> angle;        // [rad] encoders on the motor's side of the gear; hands 0..1
  JointArray<double> current;      // [A]
  JointArray<double> temperature;  // [deg C]
  JointArray<std::uint8_t> overheating;  // 0 normal, 1 to 3: how far the board holds back
  Vec3 accelerometer = Vec3::Zero();     // [m/s^2] in T; a robot at rest reads about (0, 0, -9.81)
  Vec3 gyroscope = Vec3::Zero();         // [rad/s] in T
  double angle_x = 0;                    // [rad] torso roll, fused on the chest board
  double angle_y = 0;                    // [rad] torso pitch
  double angle_z = 0;                    // [rad] torso yaw, integrated; drifts
  std::array<FootForces, 2> feet;        // by Foot
  std::array<SonarEchoes, 2> sonar{};    // left, right receiver
  BatteryState battery;
  TouchState touch;
  LedState leds{};  // as their boards show them
};

}  // namespace nao
