#pragma once

#include <vector>

#include "core/robot_io.h"
#include "sim/body_motion.h"
#include "sim/drive.h"
#include "sim/external_force.h"
#include "sim/ground_contact.h"
#include "sim/joint_stops.h"

namespace nao::sim {

/// The forces on a robot as functions of its state alone, without a time step: what the modes Rk4
/// and Reference integrate, and what the implicit mode tends to as its step goes to 0. Servos,
/// stops and ground follow the laws of Drive, JointStops and GroundContact; where the ground holds
/// a point stays for the length of a step. Friction, hold and play are none: they have no
/// derivative.
class SmoothForces {
 public:
  SmoothForces(int root_speeds, Drive& drive, JointStops& stops, const GroundContact& ground)
      : root_speeds_(root_speeds), drive_(drive), stops_(stops), ground_(ground) {}

  /// What stays the same over a step.
  void hold(const JointCommand& command, const std::vector<ExternalForce>& external) {
    command_ = &command;
    external_ = &external;
  }

  /// Torques by speed of the tree, and forces on its bodies, in `state`, whose bodies move so.
  void calc(const double* q, const double* u, const std::vector<BodyMotion>& motion,
            Eigen::VectorXd& torque, std::vector<ExternalForce>& on_bodies) {
    torque.setZero();  // of the tree's size already
    drive_.addSmooth(*command_, q, u, torque);
    stops_.addSmooth(q, u, torque);
    on_bodies = *external_;
    ground_.addSmooth(motion, on_bodies);
  }

  int rootSpeedCount() const { return root_speeds_; }

 private:
  int root_speeds_;
  Drive& drive_;
  JointStops& stops_;
  const GroundContact& ground_;
  const JointCommand* command_ = nullptr;
  const std::vector<ExternalForce>* external_ = nullptr;
};

}  // namespace nao::sim
