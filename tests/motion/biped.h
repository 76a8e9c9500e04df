#pragma once

#include <memory>
#include <string>

#include "core/robot_model.h"

namespace nao::test {

/// A bare biped with a Nao's leg hinges and round lengths: torso, six hinges a leg, one yaw-pitch
/// motor, 4 kg torso and 0.1 kg per link. Eleven motors, in the order of the left leg, then the
/// right without its yaw-pitch.
inline std::shared_ptr<RobotModel> makeBiped() {
  auto model = std::make_shared<RobotModel>();
  model->name = "biped";
  model->cycle = fromSeconds(0.01);
  Body torso;
  torso.name = "Torso";
  torso.mass = 4;
  torso.p_BoBcm = Vec3(0, 0, 0.05);
  model->bodies.push_back(torso);
  const double h = std::sqrt(0.5);
  for (const double side : {1.0, -1.0}) {
    const std::string prefix = side > 0 ? "L" : "R";
    const std::array<const char*, 6> names = {"HipYawPitch", "HipRoll",    "HipPitch",
                                              "KneePitch",   "AnklePitch", "AnkleRoll"};
    const std::array<Vec3, 6> axes = {Vec3(0, h, -side * h), Vec3::UnitX(), Vec3::UnitY(),
                                      Vec3::UnitY(),         Vec3::UnitY(), Vec3::UnitX()};
    const std::array<Vec3, 6> offsets = {
        Vec3(0, side * 0.05, -0.08), Vec3::Zero(),     Vec3::Zero(),
        Vec3(0.005, 0, -0.1),        Vec3(0, 0, -0.1), Vec3::Zero()};
    for (std::size_t i = 0; i < 6; ++i) {
      Body body;
      body.name = prefix + names[i];
      body.parent = i == 0 ? 0 : static_cast<int>(model->bodies.size()) - 1;
      body.X_PB = translation(offsets[i]);
      body.axis = axes[i];
      body.mass = 0.1;
      Coordinate hinge;
      hinge.name = body.name;
      hinge.joint = toJoint(side < 0 && i == 0 ? 0 : model->actuators.size());
      const int coordinate = static_cast<int>(model->coordinates.size());
      model->bodies.push_back(body);
      model->coordinates.push_back(hinge);
      if (side < 0 && i == 0) {
        model->actuators[0].coordinates.push_back(coordinate);
        continue;
      }
      Actuator motor;
      motor.name = body.name;
      motor.coordinates = {coordinate};
      motor.lower = i == 3 ? 0 : -2;
      motor.upper = 2;
      motor.max_velocity = 6;
      model->actuators.push_back(motor);
    }
    FootModel foot;
    foot.body = static_cast<int>(model->bodies.size()) - 1;
    foot.X_BS = translation(Vec3(0, 0, -0.05));
    foot.outline = {{0.1, -0.04}, {0.1, 0.04}, {-0.05, 0.04}, {-0.05, -0.04}};
    model->feet.push_back(foot);
  }
  model->groups["LLeg"] = {"LHipYawPitch", "LHipRoll",    "LHipPitch",
                           "LKneePitch",   "LAnklePitch", "LAnkleRoll"};
  return model;
}

}  // namespace nao::test
