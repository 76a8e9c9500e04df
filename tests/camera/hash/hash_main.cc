// Prints the hash of pictures from given poses: everything a camera does is on. The poses are exact
// fractions, so that not even a sine can differ between machines.

#include <cinttypes>
#include <cstdio>

#include "camera/color_conversion.h"
#include "camera/eye.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

SceneFrame scene() {
  SceneFrame scene = fieldScene();
  WorldModel& world = worldOf(scene);
  world.ground_grain = 0.15;
  Shape board = makeShape(Shape::Kind::Box, {0.2, 0.5, 0.5}, {}, {1.5, 0.6, 0.3});
  std::vector<std::uint32_t> squares;
  for (std::uint32_t i = 0; i < 256; ++i) squares.push_back(i * 0x01030507u & 0xffffffu);
  board.texture = std::make_shared<const Texture>(makeTexture(16, 16, squares));
  world.obstacles.push_back({"board", board, {}});
  scene.balls.push_back({0.05, {0.6, -0.2, 0.05}, {235, 235, 235}, Mat3::Identity(), true});
  scene.robots.push_back(simpleRobot("other", translation({2, -0.5, 0.32})));
  scene.robots.push_back(simpleRobot("watcher", translation({-0.5, 0, 0.3})));
  SceneFrame::Robot& watcher = scene.robots.back();
  for (Pose& X_WB : watcher.X_WB) X_WB.linear() << 0.96, 0, 0.28, 0, 1, 0, -0.28, 0, 0.96;
  watcher.w_WB.assign(3, Vec3(0.25, -0.5, 1));
  return scene;
}

std::uint64_t hashOf(const char* version, bool all_effects) {
  SceneFrame shown = scene();
  RobotModel model = *shown.robots[1].model;
  model.version = version;
  CameraModel& camera = model.cameras[0];
  camera.effects = {true, true, true, all_effects, all_effects, all_effects};
  camera.distortion = {-0.0625, 0.0625, -0.0078125, 0.00390625};
  shown.robots[1].model = std::make_shared<const RobotModel>(model);
  Eye eye(model, 0, 1);
  Renderer renderer;
  std::uint64_t hash = 0;
  for (int i = 0; i < 5; ++i) {
    shown.time += std::chrono::milliseconds(33);
    shown.balls[0].p_W.x() += 0.0625;
    const Raster& raster = eye.look(shown, {1, 0}, {320, 240}, {}, renderer);
    Image image;
    image.bytes = std::make_shared<const Bytes>(toBytes(raster, ColorSpace::kYUV422));
    hash = hash * 31 + image.hash();
  }
  return hash;
}

}  // namespace
}  // namespace nao::camera

int main() {
  for (const char* version : {"V3.3", "V4.0", "V6.0"}) {
    for (const bool all : {false, true}) {
      std::printf("%s %d %016" PRIx64 "\n", version, all ? 1 : 0,
                  nao::camera::hashOf(version, all));
    }
  }
}
