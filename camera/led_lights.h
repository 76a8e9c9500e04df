#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/leds.h"
#include "core/robot_model.h"
#include "core/shape.h"

namespace nao::camera {

/// A light that is on, on its body.
struct LedLight {
  int body = 0;
  Vec3 p_B = Vec3::Zero();  // [m]
  double radius = 0;        // [m]
  Color color;
};

/// Where a Nao's lights sit: eyes of eight sectors, ears of ten, chest, feet and, from V4 on,
/// twelve on the head. Places are by eye from pictures of the robot; only the chest button's is
/// published.
class LedLights {
 public:
  /// Those that are on. Robots without a Nao's lights or bodies have none.
  std::vector<LedLight> lit(const std::shared_ptr<const RobotModel>& model, const LedState& leds);

 private:
  /// A lamp of one to three colours: which lights of LedState make it, -1: no such colour.
  struct Lamp {
    int body = 0;
    Vec3 p_B = Vec3::Zero();
    double radius = 0;
    std::array<int, 3> leds = {-1, -1, -1};
  };
  static std::vector<Lamp> lampsOf(const RobotModel& model);

  std::map<std::shared_ptr<const RobotModel>, std::vector<Lamp>> lamps_;
};

}  // namespace nao::camera
