#pragma once

#include <memory>

#include "core/robot_model.h"

namespace nao::bench {

/// The same robot in MuJoCo, from the same RobotModel: same tree, masses, rotor inertias, gains,
/// torque limits, stops, four corners per sole and body spheres on the same plane. For comparison.
class MujocoNao {
 public:
  MujocoNao(const RobotModel& model, double step_s);
  ~MujocoNao();

  /// Puts it on its soles with these angles, and holds them from now on.
  void stand(const JointArray<double>& angles);
  void step();
  bool stands() const;  // torso higher than 0.25 m

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::bench
