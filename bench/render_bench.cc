// Frames a second of the software renderer on one core, colour conversion included.

#include <benchmark/benchmark.h>

#include "camera/color_conversion.h"
#include "camera/eye.h"
#include "camera/renderer.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

/// A robot of as many solids as a Nao shows: 15 boxes and 15 capsules.
SceneFrame::Robot detailedRobot(double x, double y) {
  SceneFrame::Robot robot = simpleRobot("robot", translation({x, y, 0.32}));
  RobotModel model = *robot.model;
  for (int i = 0; i < 14; ++i) {
    const Vec3 p(0, 0.03 * (i % 5 - 2), 0.03 * (i - 10));
    model.bodies[0].visuals.push_back(
        makeShape(Shape::Kind::Capsule, {0.03, 0, 0.06}, {220, 220, 220}, p));
    model.bodies[0].visuals.push_back(
        makeShape(Shape::Kind::Box, {0.05, 0.05, 0.06}, {160, 160, 170}, p));
  }
  robot.model = std::make_shared<const RobotModel>(model);
  return robot;
}

SceneFrame sceneWith(int robots) {
  SceneFrame scene = fieldScene();
  worldOf(scene).ground_grain = 0.12;  // as in worlds/field_2011.yaml
  for (int i = 0; i < robots; ++i) {
    scene.robots.push_back(detailedRobot(0.8 + 0.3 * i, i % 2 == 0 ? 0.25 : -0.3));
  }
  return scene;
}

/// Arguments: width in pixels, number of robots in view.
void renderYuv422(benchmark::State& state) {
  const int width = static_cast<int>(state.range(0));
  const SceneFrame scene = sceneWith(static_cast<int>(state.range(1)));
  const View view = viewFrom({-1, 0, 0.5}, 0.25, {width, width * 3 / 4});
  Renderer renderer;
  for (auto unused : state) {
    benchmark::DoNotOptimize(toBytes(renderer.render(scene, view), ColorSpace::kYUV422).data());
  }
  state.counters["fps"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
/// The same through an eye: exposure, white balance, fall-off to the corners and noise, too. A
/// second robot behind the scene looks at it.
void cameraYuv422(benchmark::State& state) {
  const int width = static_cast<int>(state.range(0));
  SceneFrame scene = sceneWith(6);
  SceneFrame::Robot watcher = simpleRobot("watcher", translation({-1, 0, 0.3}));
  RobotModel model = *watcher.model;
  model.version = "V5.0";
  model.cameras[0].X_BC.linear() = rotationFromRpy(0, 0.25, 0);
  model.cameras[0].effects = {true, true, true, false, false, false};
  watcher.model = std::make_shared<const RobotModel>(model);
  scene.robots.push_back(watcher);
  Eye eye(*watcher.model, 0, 1);
  Renderer renderer;
  for (auto unused : state) {
    scene.time += std::chrono::milliseconds(33);
    const Raster& picture = eye.look(scene, {6, 0}, {width, width * 3 / 4}, {}, renderer);
    benchmark::DoNotOptimize(toBytes(picture, ColorSpace::kYUV422).data());
  }
  state.counters["fps"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(cameraYuv422)->ArgName("width")->Arg(640)->Arg(320)->Unit(benchmark::kMillisecond);

BENCHMARK(renderYuv422)
    ->ArgNames({"width", "robots"})
    ->Args({640, 0})
    ->Args({320, 0})
    ->Args({640, 6})
    ->Args({320, 6})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace nao::camera

BENCHMARK_MAIN();
