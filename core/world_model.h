#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/frames.h"
#include "core/shape.h"

namespace nao {

/// Paint on the ground: a straight line, or a ring (a disc when its width is twice its radius).
struct GroundMark {
  enum class Kind { Line, Ring };
  Kind kind = Kind::Line;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();  // [m] line: centre of one end. ring: centre
  Eigen::Vector2d to = Eigen::Vector2d::Zero();    // [m] line: centre of the other end
  double radius = 0;                               // [m] ring: of the middle of the paint
  double width = 0.05;                             // [m]
  Color color{255, 255, 255};
};

/// How touching bodies push back. The laws stand in sim/ground_contact.h and sim/touching.h.
struct Material {
  double friction = 0.7;               // Coulomb coefficient
  double torsional_friction = 0;       // [m] largest torque about the normal per normal force
  double restitution = 0;              // part of the approach speed that comes back, 0 to 1
  double stiffness = 30e3;             // [N/m] per contact point, normal
  double damping = 300;                // [N s/m]
  double tangential_stiffness = 20e3;  // [N/m]
  double tangential_damping = 100;     // [N s/m]
};

/// A solid that stays where it is.
struct Obstacle {
  std::string name;
  Shape shape;  // X_BS is X_WS
  Material material;
};

struct Ball {
  std::string name = "ball";
  double radius = 0.0325;             // [m]
  double mass = 0.055;                // [kg]
  double inertia_factor = 0.4;        // I = factor m r^2: 0.4 solid, 0.667 a thin shell
  double rolling_deceleration = 0.5;  // [1/s], a = -c v
  Material material;
  Vec3 p_W = Vec3::Zero();  // [m] start
  Color color{255, 120, 0};
  bool has_patches = false;  // twelve black ones, as on a soccer ball
};

/// Where a robot of the world starts. The command line's --robot options replace the list.
struct RobotPlace {
  std::string name;
  std::string model;
  Pose2 start;
  std::optional<Color> team;  // of its shirt
};

/// Everything fixed about a world, read from worlds/*.yaml. Immutable once loaded.
struct WorldModel {
  std::string name;
  double gravity = 9.80665;  // [m/s^2]
  Material ground;
  Color ground_color{60, 130, 60};
  Color sky_color{170, 190, 210};
  double ground_grain = 0;  // how far the carpet's brightness strays, part of it; for the eye
  double light = 1;         // on everything, by that of a usual hall; cameras adapt to it
  Eigen::Vector2d ground_size = Eigen::Vector2d(10, 10);  // [m] painted part; the plane is endless
  std::vector<GroundMark> marks;
  Vec3 ground_normal = Vec3::UnitZ();  // of the plane through the origin; tilted: a slope
  std::vector<Obstacle> obstacles;
  std::vector<Ball> balls;
  std::vector<RobotPlace> robots;
};

/// @throws InputError naming file, line and what was expected.
std::shared_ptr<const WorldModel> loadWorldModel(const std::string& file);

}  // namespace nao
