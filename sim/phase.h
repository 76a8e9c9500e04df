#pragma once

#include <functional>

namespace nao::sim {

/// The parts of a step and of a reading of sensors, for whoever measures what they cost.
enum class Phase {
  Touching,    // forces between robots, balls and obstacles
  Effects,     // what effects do to commands and drives
  Dynamics,    // mass matrix and bias forces
  Drives,      // motors and joint stops
  Ground,      // which points touch the ground
  Solve,       // the step's linear systems, until all limits agree
  Kinematics,  // moving on, and where the bodies are then
  Encoders,    // angles and currents
  Imu,         // inertial unit
  FootForces,  // force sensors under the feet
  Sonar,
  Touch,          // bumpers, tactile sensors, button
  SensorEffects,  // what effects do to sensors
};

/// Told as each phase of a robot's step ends; sim itself reads no clock.
using PhaseWatch = std::function<void(Phase)>;

}  // namespace nao::sim
