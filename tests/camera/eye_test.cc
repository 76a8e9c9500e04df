// Lens, shutter and latency: where things are seen when a camera is no pinhole.

#include "camera/eye.h"

#include <gtest/gtest.h>

#include <cmath>

#include "camera/render_queue.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

/// A robot's head at 1 m that looks along x with this lens and these effects.
SceneFrame sceneFor(const CameraModel& change) {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = worldOf(scene).sky_color = {0, 0, 0};
  worldOf(scene).ground_size = {1e7, 1e7};
  SceneFrame::Robot robot = simpleRobot("a", translation({0, 0, 0.8}));
  RobotModel model = *robot.model;
  for (Body& body : model.bodies) body.visuals.clear();
  CameraModel camera = model.cameras[0];
  camera.hfov = change.hfov > 0 ? change.hfov : camera.hfov;
  camera.vfov = change.vfov > 0 ? change.vfov : camera.vfov;
  camera.distortion = change.distortion;
  camera.effects = change.effects;
  camera.latency = change.latency;
  model.cameras = {camera};
  model.version = "V4.0";
  robot.model = std::make_shared<const RobotModel>(model);
  robot.w_WB.assign(3, Vec3::Zero());
  scene.robots = {robot};
  return scene;
}

void addDot(SceneFrame& scene, const Vec3& p_C) {
  const View view = viewOf(scene, {0, 0}, {640, 480});
  scene.balls.push_back({0.004 * p_C.x(), view.X_WC * p_C, {255, 255, 255}, Mat3::Identity()});
}

/// The middle of what is bright, weighted by brightness.
Eigen::Vector2d middleOf(const Raster& raster) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (int row = 0; row < raster.size().height; ++row) {
    for (int column = 0; column < raster.size().width; ++column) {
      const double w = raster.colors(row)[column] & 0xff;
      sum += w * Eigen::Vector2d(column + 0.5, row + 0.5);
      weight += w;
    }
  }
  return sum / weight;
}

// The calibration of one V4/V5, the only one published, and a lens much worse.
constexpr LensDistortion kCalibrated{-0.0545212, 0.0691973, -0.00241095, -0.00112245};
constexpr LensDistortion kFishEye{-0.3, 0.1, 0.01, -0.01};

/// Points all over the picture, against the lens formula.
void expectPointsWhereFormulaSays(const PublishedLens& lens, const LensDistortion* distortion) {
  CameraModel change;
  change.hfov = lens.hfov_deg * M_PI / 180;
  change.vfov = lens.vfov_deg * M_PI / 180;
  change.effects.distortion = distortion != nullptr;
  if (distortion != nullptr) change.distortion = *distortion;
  const double tolerance = distortion == nullptr ? 0.5 : 0.7;  // [px], the cameras' bars
  for (const double right : {-0.8, -0.3, 0.0, 0.5, 0.8}) {
    for (const double down : {-0.8, 0.0, 0.4, 0.8}) {
      SceneFrame scene = sceneFor(change);
      const double x = right * std::tan(change.hfov / 2), y = down * std::tan(change.vfov / 2);
      addDot(scene, 1.5 * Vec3(1, -x, -y));
      Eye eye(*scene.robots[0].model, 0, 1);
      Renderer renderer;
      const auto seen = middleOf(eye.look(scene, {0, 0}, {640, 480}, {}, renderer));
      const LensDistortion& d = change.distortion;
      const double r2 = x * x + y * y, radial = 1 + d.k1 * r2 + d.k2 * r2 * r2;
      const double shown_x = x * radial + 2 * d.p1 * x * y + d.p2 * (r2 + 2 * x * x);
      const double shown_y = y * radial + d.p1 * (r2 + 2 * y * y) + 2 * d.p2 * x * y;
      EXPECT_NEAR(seen.x(), 320 + 320 / std::tan(change.hfov / 2) * shown_x, tolerance)
          << lens.sensor << " " << right << " " << down;
      EXPECT_NEAR(seen.y(), 240 + 240 / std::tan(change.vfov / 2) * shown_y, tolerance)
          << lens.sensor << " " << right << " " << down;
    }
  }
}

TEST(Eye, KnownPointsAreSeenWhereTheLensFormulaSays) {
  for (const PublishedLens& lens : kPublishedLenses) {
    for (const LensDistortion* distortion :
         {static_cast<const LensDistortion*>(nullptr), &kCalibrated, &kFishEye})
      expectPointsWhereFormulaSays(lens, distortion);
  }
}

// A head that turns left by w sees a thing at rest wander to the right: f w t, t the row's time.
TEST(Eye, ARollingShutterSlantsWhatAHeadTurnsPast) {
  CameraModel change;
  change.effects.rolling_shutter = true;
  const double w = 2;  // [rad/s]
  for (const double down : {-0.8, 0.0, 0.8}) {
    SceneFrame scene = sceneFor(change);
    addDot(scene, 1.5 * Vec3(1, 0, -down * std::tan(0.6423 / 2)));
    scene.robots[0].w_WB[1] = Vec3(0, 0, w);
    Eye eye(*scene.robots[0].model, 0, 1);
    Renderer renderer;
    const auto seen = middleOf(eye.look(scene, {0, 0}, {640, 480}, {}, renderer));
    const double time = seen.y() / 480 * sensorType("MT9M114").readout;
    const double focal_length = 320 / std::tan(0.8343 / 2);
    EXPECT_NEAR(seen.x(), 320 + focal_length * std::tan(w * time), 0.7) << down;
  }
}

TEST(Eye, AHeadAtRestSeesTheSameThroughARollingShutter) {
  CameraModel change;
  SceneFrame scene = sceneFor(change);
  addDot(scene, {1, 0.1, 0.1});
  Renderer renderer;
  Eye ideal(*scene.robots[0].model, 0, 1);
  const Raster expected = ideal.look(scene, {0, 0}, {320, 240}, {}, renderer);
  change.effects.rolling_shutter = change.effects.motion_blur = true;
  SceneFrame other = sceneFor(change);
  other.balls = scene.balls;
  Eye eye(*other.robots[0].model, 0, 1);
  const Raster& seen = eye.look(other, {0, 0}, {320, 240}, {}, renderer);
  for (int row = 0; row < 240; ++row) {
    for (int column = 0; column < 320; ++column)
      ASSERT_EQ(seen.colors(row)[column], expected.colors(row)[column]);
  }
}

TEST(Eye, MotionBlurSmearsAlongTheTurn) {
  CameraModel change;
  change.effects.motion_blur = true;
  const auto widthAt = [&](double w) {
    SceneFrame scene = sceneFor(change);
    addDot(scene, {1.5, 0, 0});
    scene.robots[0].w_WB[1] = Vec3(0, 0, w);
    Eye eye(*scene.robots[0].model, 0, 1);
    Renderer renderer;
    const Raster& raster = eye.look(scene, {0, 0}, {640, 480}, {}, renderer);
    int first = 640, last = 0;
    for (int column = 0; column < 640; ++column) {
      if ((raster.colors(240)[column] & 0xff) < 15) continue;
      first = std::min(first, column);
      last = column;
    }
    return last - first;
  };
  // 10 ms of exposure, four fifths between the first part and the last: 720 px/rad 2 rad/s 8 ms.
  EXPECT_NEAR(widthAt(2) - widthAt(0), 11.6, 2);
}

TEST(Eye, ALatePictureShowsItsOwnTimeWhenItComes) {
  CameraModel change;
  change.latency = std::chrono::milliseconds(50);
  SceneFrame scene = sceneFor(change);
  const auto feed = std::make_shared<ImageFeed>();
  const auto id = feed->subscribe({0, {40, 30}, ColorSpace::kYUV422, 10});
  RenderQueue queue(feed);
  Renderer renderer;
  std::vector<std::pair<int, int>> arrivals;  // [ms] when, and what it shows
  std::shared_ptr<const Image> last;
  for (int ms = 0; ms <= 400; ms += 2) {
    const SimTime now{std::chrono::milliseconds(ms)};
    if (queue.anyDue(now)) {
      auto offered = std::make_shared<SceneFrame>(scene);
      offered->time = now;
      EXPECT_TRUE(queue.offer(offered, 0));
    }
    while (queue.renderNext(renderer)) {
    }
    const auto image = feed->latest(id);
    if (image == last) continue;
    last = image;
    arrivals.emplace_back(ms, static_cast<int>(toSeconds(image->time) * 1000 + 0.5));
  }
  const std::vector<std::pair<int, int>> expected = {{50, 0}, {150, 100}, {250, 200}, {350, 300}};
  EXPECT_EQ(arrivals, expected);
}

TEST(Eye, SettingsAndEffectsReachThePictures) {
  CameraModel change;
  change.effects.response = true;
  auto scene = std::make_shared<SceneFrame>(sceneFor(change));
  worldOf(*scene).sky_color = worldOf(*scene).ground_color = {100, 100, 100};
  const auto feed = std::make_shared<ImageFeed>();
  const auto id = feed->subscribe({0, {40, 30}, ColorSpace::kYuv, 10});
  RenderQueue queue(feed);
  Renderer renderer;
  const auto brightness = [&](double time) {
    auto offered = std::make_shared<SceneFrame>(*scene);
    offered->time = SimTime(fromSeconds(time));
    queue.offer(offered, 0);
    queue.renderNext(renderer);
    return static_cast<int>((*feed->latest(id)->bytes)[600]);
  };
  const int before = brightness(0);
  const SensorType& type = sensorType("MT9M114");
  CameraSettings settings;
  settings.set(*findParameter(type, 11), 0);
  settings.set(*findParameter(type, 17), 10);
  feed->setSettings(0, settings);
  EXPECT_LT(brightness(1), before / 2);
  feed->setEffects(0, {});
  EXPECT_EQ(brightness(2), 100);  // a pinhole's, whatever is set
}

}  // namespace
}  // namespace nao::camera
