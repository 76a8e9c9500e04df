#pragma once

#include <memory>
#include <vector>

#include "core/robot_model.h"

namespace nao::bench {

/// The same robot in MuJoCo, from the same RobotModel: same tree, masses, rotor inertias, drives,
/// torque limits, stops, four corners per sole and body spheres on the same plane, and collision
/// solids that meet each other but for the pairs that never do. For comparison.
class MujocoNao {
 public:
  /// `model` must outlive it.
  MujocoNao(const RobotModel& model, double step_s);
  ~MujocoNao();

  /// Puts it on its soles with these angles, and holds them from now on.
  void stand(const JointArray<double>& angles);
  /// What the motors follow from now on.
  void command(const JointArray<double>& angles);
  void step();
  bool stands() const;    // torso higher than 0.25 m
  Vec3 position() const;  // [m] of the torso

  struct State {
    std::vector<double> q, u, warm_start;
  };
  State state() const;
  void setState(const State& state);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::bench
