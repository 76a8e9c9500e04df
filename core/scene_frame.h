#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.h"
#include "core/leds.h"
#include "core/robot_model.h"
#include "core/sim_time.h"
#include "core/world_model.h"

namespace nao {

/// Ground truth at one instant: where everything really is. For camera, validation and UsarSim
/// only; no NaoQi service may see it (tests/architecture).
struct SceneFrame {
  struct Robot {
    std::string name;
    std::shared_ptr<const RobotModel> model;
    std::vector<Pose> X_WB;  // by body of the model
    LedState leds{};         // by ledNames()
    std::vector<Vec3> w_WB;  // [rad/s] how fast each body turns, in W
    std::optional<Color> team;
    std::vector<float> lens_dirt{};  // by camera: 0 clean to 1 blind; empty: all are clean
  };
  struct Ball {
    double radius = 0;  // [m]
    Vec3 p_W = Vec3::Zero();
    Color color;
    Mat3 R_W = Mat3::Identity();
    bool has_patches = false;
  };

  SimTime time{};
  std::shared_ptr<const WorldModel> world;
  std::vector<Robot> robots;
  std::vector<Ball> balls;
};

}  // namespace nao
