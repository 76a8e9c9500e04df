#pragma once

#include <memory>
#include <ostream>

#include "camera/renderer.h"
#include "core/scene_frame.h"

namespace nao::camera {

inline constexpr double kQuarterTurn = 1.5707963267948966;  // [rad]

/// The fields of view that are published of the Naos' cameras.
struct PublishedLens {
  const char* sensor;
  double hfov_deg, vfov_deg;

  Pinhole pinhole(ImageSize size) const {
    return makePinhole(hfov_deg * kQuarterTurn / 90, vfov_deg * kQuarterTurn / 90, size);
  }
};
inline constexpr PublishedLens kPublishedLenses[] = {
    {"OV7670", 47.8, 36.8}, {"MT9M114", 60.9, 47.6}, {"OV5640", 56.3, 43.7}};

inline void PrintTo(const PublishedLens& lens, std::ostream* out) { *out << lens.sensor; }

/// Looks from `p_W` along x, turned down by `pitch` [rad].
inline View viewFrom(const Vec3& p_W, double pitch, ImageSize size = {640, 480}) {
  View view;
  view.X_WC = translation(p_W);
  view.X_WC.linear() = rotationFromRpy(0, pitch, 0);
  view.lens = makePinhole(0.8343, 0.6423, size);  // V3.3: 47.8 by 36.8 degrees
  return view;
}

inline Shape makeShape(Shape::Kind kind, const Vec3& size, Color color, const Vec3& p = {0, 0, 0}) {
  Shape shape;
  shape.kind = kind;
  shape.size = size;
  shape.color = color;
  shape.X_BS = translation(p);
  return shape;
}

/// Carpet and sky, nothing else.
inline SceneFrame emptyScene() {
  SceneFrame scene;
  scene.world = std::make_shared<WorldModel>();
  return scene;
}

/// The world of a scene made by these functions, to put things in.
inline WorldModel& worldOf(SceneFrame& scene) {
  return const_cast<WorldModel&>(*scene.world);  // NOLINT: made non-const above
}

inline void addLine(WorldModel& world, double x1, double y1, double x2, double y2) {
  GroundMark mark;
  mark.from = {x1, y1};
  mark.to = {x2, y2};
  world.marks.push_back(mark);
}

/// A soccer field of 2011: 6 m by 4 m, with goals and an orange ball.
inline SceneFrame fieldScene() {
  SceneFrame scene = emptyScene();
  WorldModel& world = worldOf(scene);
  world.ground_size = {7.4, 5.4};
  for (const double side : {-1.0, 1.0}) {
    addLine(world, -3.025, side * 2, 3.025, side * 2);
    addLine(world, side * 3, -2, side * 3, 2);
    addLine(world, side * 2.4, -1.1, side * 2.4, 1.1);
    addLine(world, side * 2.4, 1.1, side * 3, 1.1);
    addLine(world, side * 2.4, -1.1, side * 3, -1.1);
    const Color color = side > 0 ? Color{240, 220, 0} : Color{0, 80, 220};
    for (const double post : {-0.75, 0.75}) {
      world.obstacles.push_back(
          {"post",
           makeShape(Shape::Kind::Cylinder, {0.05, 0, 0.8}, color, {side * 3, post, 0.4}),
           {}});
    }
  }
  addLine(world, 0, -2, 0, 2);
  GroundMark circle;
  circle.kind = GroundMark::Kind::Ring;
  circle.radius = 0.6;
  world.marks.push_back(circle);
  scene.balls.push_back({0.0325, {1.0, 0.1, 0.0325}, {255, 120, 0}, Mat3::Identity()});
  return scene;
}

/// A robot of a trunk, a head that carries a camera (looking along x) and a foot.
inline SceneFrame::Robot simpleRobot(const std::string& name, const Pose& X_WT) {
  auto model = std::make_shared<RobotModel>();
  Body trunk, head, foot;
  trunk.visuals = {makeShape(Shape::Kind::Box, {0.1, 0.16, 0.2}, {230, 230, 235})};
  head.visuals = {makeShape(Shape::Kind::Capsule, {0.06, 0, 0.05}, {240, 240, 240})};
  foot.visuals = {makeShape(Shape::Kind::Box, {0.16, 0.18, 0.03}, {90, 90, 100})};
  model->bodies = {trunk, head, foot};
  CameraModel camera;
  camera.name = "CameraTop";
  camera.body = 1;
  camera.X_BC = translation({0.05, 0, 0.02});
  camera.hfov = 0.8343;
  camera.vfov = 0.6423;
  camera.frame_rates = {5, 10, 15, 30};
  model->cameras = {camera};
  SceneFrame::Robot robot;
  robot.name = name;
  robot.model = model;
  robot.X_WB = {X_WT, X_WT * translation({0, 0, 0.18}), X_WT * translation({0, 0, -0.3})};
  return robot;
}

inline bool isColor(Pixel pixel, Color color) { return pixel == toPixel(color); }

}  // namespace nao::camera
