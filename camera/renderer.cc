#include "camera/renderer.h"

#include <algorithm>
#include <tuple>

#include "camera/ground_painter.h"
#include "camera/ground_truth.h"
#include "camera/light.h"
#include "camera/soft_meeting.h"
#include "camera/sphere_painter.h"
#include "core/check.h"

namespace nao::camera {
namespace {

/// A camera looks out of its own body: parts of its robot this near [m] do not stand in its way.
constexpr double kOwnClearance = 0.01;

/// False for the poses of a simulation that has blown up: not a number, or a thousand km away.
bool isPlausible(const Pose& pose) { return (pose.matrix().array().abs() < 1e6).all(); }

/// Whether a sphere may show on the picture: it is beyond the near plane and not beside one of
/// the four side planes of the picture.
bool mayShow(const Vec3& p_C, double radius, const Pinhole& lens) {
  if (p_C.x() + radius < kNearPlane) return false;
  const double tan_left = lens.cx / lens.fx;
  const double tan_up = lens.cy / lens.fy;
  const double past_side = std::abs(p_C.y()) - tan_left * p_C.x();
  const double past_top = std::abs(p_C.z()) - tan_up * p_C.x();
  return past_side <= radius * std::sqrt(1 + tan_left * tan_left) &&
         past_top <= radius * std::sqrt(1 + tan_up * tan_up);
}

Roundness roundnessFor(const Shape& shape, double depth, const Pinhole& lens) {
  const double radius_on_picture = lens.fx * shape.size.x() / std::max(depth, kNearPlane);
  if (radius_on_picture < 6) return Roundness::Coarse;  // corners lie 0.5 px inside the circle
  return radius_on_picture < 50 ? Roundness::Medium : Roundness::Fine;
}

/// An order that depends on the things alone, not on the list they came in.
auto sortKey(const Pose& X_CS, const Shape& shape, Pixel color) {
  const Vec3 p = X_CS.translation();
  return std::make_tuple(p.squaredNorm(), p.x(), p.y(), p.z(), shape.kind, shape.size.x(),
                         shape.size.y(), shape.size.z(), color);
}

auto sortKey(const Shadow& shadow) {
  return std::make_tuple(shadow.centre.x(), shadow.centre.y(), shadow.half_length,
                         shadow.half_width, shadow.darkness, shadow.direction.x());
}

}  // namespace

View viewOf(const SceneFrame& scene, CameraPlace place, ImageSize size) {
  NAO_CHECK(place.robot < scene.robots.size());
  const SceneFrame::Robot& robot = scene.robots[place.robot];
  NAO_CHECK(place.camera < robot.model->cameras.size());
  const CameraModel& camera = robot.model->cameras[place.camera];
  View view;
  view.X_WC = robot.X_WB[camera.body] * camera.X_BC;
  view.lens = makePinhole(camera.hfov, camera.vfov, size);
  return view;
}

Raster& Renderer::render(const SceneFrame& scene, CameraPlace place, ImageSize size) {
  return render(scene, place, viewOf(scene, place, size));
}

Raster& Renderer::render(const SceneFrame& scene, CameraPlace place, const View& view) {
  labels_ = false;
  return renderFor(scene, view, place);
}

Raster& Renderer::render(const SceneFrame& scene, const View& view) {
  labels_ = false;
  return renderFor(scene, view, std::nullopt);
}

Raster& Renderer::renderLabels(const SceneFrame& scene, std::optional<CameraPlace> own,
                               const View& view) {
  labels_ = true;
  return renderFor(scene, view, own);
}

Raster& Renderer::renderFor(const SceneFrame& scene, const View& view,
                            std::optional<CameraPlace> own) {
  NAO_CHECK(scene.world != nullptr);
  raster_.reset(view.lens.size);
  if (!isPlausible(view.X_WC)) {
    raster_.fill(labels_ ? kSkyLabel : toPixel(scene.world->sky_color));
    return raster_;
  }
  const GroundForms ground(view);
  collectItems(scene, view, own);
  sortItems();
  if (labels_) {
    paintGroundLabels(*scene.world, ground, raster_);
  } else {
    paintGround(*scene.world, ground, grain_, raster_);
    for (const Shadow& shadow : shadows_) paintShadow(shadow, ground, raster_);
  }
  paintItems(view, ground);
  return raster_;
}

void Renderer::collectItems(const SceneFrame& scene, const View& view,
                            std::optional<CameraPlace> own) {
  items_.clear();
  shadows_.clear();
  made_.clear();
  const Labels labels(scene);
  for (std::size_t i = 0; i < scene.world->obstacles.size(); ++i) {
    const Shape& shape = scene.world->obstacles[i].shape;
    Item item;
    item.shape = &shape;
    item.color = labels_ ? labels.ofObstacle(i) : toPixel(shape.color);
    collect(item, shape.X_BS, view);
  }
  for (std::size_t i = 0; i < scene.balls.size(); ++i)
    collectBall(scene.balls[i], labels.ofBall(i), view);
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const bool is_own = own && own->robot == i;
    const SceneFrame::Robot& robot = scene.robots[i];
    collectRobot(robot, labels.ofRobot(i), view,
                 is_own ? &robot.model->cameras[own->camera] : nullptr);
  }
}

void Renderer::collectBall(const SceneFrame::Ball& ball, Pixel label, const View& view) {
  Shape& sphere = made_.emplace_back();
  sphere.size.x() = ball.radius;
  Item item;
  item.shape = &sphere;
  item.color = labels_ ? label : toPixel(ball.color);
  item.has_patches = ball.has_patches && !labels_;
  Pose X_WS = translation(ball.p_W);
  X_WS.linear() = ball.R_W;
  collect(item, X_WS, view);
}

void Renderer::collectRobot(const SceneFrame::Robot& robot, Pixel label, const View& view,
                            const CameraModel* own_camera) {
  const Pose X_CW = view.X_WC.inverse();
  const int own_head = own_camera != nullptr ? own_camera->body : -1;
  for (std::size_t body = 0; body < robot.model->bodies.size(); ++body) {
    if (own_head == static_cast<int>(body)) continue;
    const Pose& X_WB = robot.X_WB[body];
    const bool wears_shirt = body == 0 && robot.team;
    for (const Shape& shape : robot.model->bodies[body].visuals) {
      const Pose X_WS = X_WB * shape.X_BS;
      if (own_camera != nullptr) {
        const Vec3 p_SC_S = (X_CW * X_WS).inverse().translation();
        if (distanceTo(shape, p_SC_S) < kOwnClearance) continue;
      }
      Item item;
      item.shape = &shape;
      item.color = labels_ ? label : toPixel(wears_shirt ? *robot.team : shape.color);
      collect(item, X_WS, view);
    }
  }
  collectLights(robot, label, view, own_head);
}

void Renderer::collectLights(const SceneFrame::Robot& robot, Pixel label, const View& view,
                             int own_head) {
  for (const LedLight& light : lights_.lit(robot.model, robot.leds)) {
    if (light.body == own_head) continue;
    Shape& sphere = made_.emplace_back();
    sphere.size.x() = light.radius;
    Item item;
    item.shape = &sphere;
    item.color = labels_ ? label : toPixel(light.color);
    item.glows = true;
    collect(item, robot.X_WB[static_cast<std::size_t>(light.body)] * translation(light.p_B), view);
  }
}

void Renderer::collect(Item item, const Pose& X_WS, const View& view) {
  item.X_CS = view.X_WC.inverse() * X_WS;
  const double radius = boundingRadius(*item.shape);
  if (!labels_ && !item.glows && isPlausible(X_WS)) {
    const Shadow shadow = shadowOf(*item.shape, X_WS);
    if (shadow.darkness > 0) shadows_.push_back(shadow);
  }
  item.is_above_ground = X_WS.translation().z() > radius;
  if (mayShow(item.X_CS.translation(), radius, view.lens)) items_.push_back(item);
}

void Renderer::sortItems() {
  std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) {
    return sortKey(a.X_CS, *a.shape, a.color) < sortKey(b.X_CS, *b.shape, b.color);
  });
  std::sort(shadows_.begin(), shadows_.end(),
            [](const Shadow& a, const Shadow& b) { return sortKey(a) < sortKey(b); });
}

void Renderer::paintItems(const View& view, const GroundForms& ground) {
  const Vec3 lamp_C = view.X_WC.linear().transpose() * towardsLamp().normalized();
  TrianglePainter triangles(view.lens, ground.inverseDepth(), raster_);
  edges_.clear();
  // Near solids first: what they hide is not even coloured. Then spheres, far ones first.
  for (const Item& item : items_) {
    if (item.shape->kind != Shape::Kind::Sphere) paintMesh(item, lamp_C, triangles, view.lens);
  }
  for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
    if (item->shape->kind != Shape::Kind::Sphere) continue;
    SphereInView sphere;
    sphere.p_C = item->X_CS.translation();
    sphere.radius = item->shape->size.x();
    sphere.color = item->color;
    sphere.thing = thingOf(*item);
    sphere.is_flat = labels_ || item->glows;
    sphere.has_hard_rim = labels_;
    sphere.has_patches = item->has_patches;
    sphere.texture = labels_ ? nullptr : item->shape->texture.get();
    sphere.R_CS = item->X_CS.linear();
    paintSphere(sphere, view.lens, lamp_C, ground.inverseDepth(), raster_);
  }
  if (!labels_) softenMeetings(ground.inverseDepth(), raster_);
  for (const SoftEdge& edge : edges_) soften(edge, ground.inverseDepth(), raster_);
}

Thing Renderer::thingOf(const Item& item) const {
  const auto number = static_cast<std::size_t>(&item - items_.data());
  return static_cast<Thing>(std::min<std::size_t>(number + 1, kRim - 1));
}

void Renderer::paintMesh(const Item& item, const Vec3& lamp_C, TrianglePainter& painter,
                         const Pinhole& lens) {
  const double depth = item.X_CS.translation().x() - boundingRadius(*item.shape);
  const Mesh& mesh = meshes_.find(*item.shape, roundnessFor(*item.shape, depth, lens));
  placeCorners(item, mesh, lamp_C);
  painter.use({item.color, labels_ ? nullptr : item.shape->texture.get(), item.is_above_ground,
               thingOf(item)});
  const bool is_cut = std::any_of(corners_.begin(), corners_.end(), [](const LitCorner& corner) {
    return corner.p_C.x() < kNearPlane;
  });
  if (!is_cut) return paintSeen(mesh, painter);
  for (const auto& [a, b, c] : mesh.triangles)
    painter.paintClipped({corners_[a], corners_[b], corners_[c]});
}

void Renderer::placeCorners(const Item& item, const Mesh& mesh, const Vec3& lamp_C) {
  const Stretch stretch = stretchOf(*item.shape);
  const Vec3 lamp_S = item.X_CS.linear().transpose() * lamp_C;
  corners_.clear();
  for (const Mesh::Vertex& vertex : mesh.vertices) {
    const Vec3 p_S =
        stretch.scale.cwiseProduct(vertex.corner) + Vec3(0, 0, vertex.end * stretch.half_length);
    const double light = labels_ ? 256 : lightStrength(vertex.normal.dot(lamp_S));
    corners_.push_back({item.X_CS * p_S, light, vertex.texture});
  }
}

void Renderer::paintSeen(const Mesh& mesh, TrianglePainter& painter) {
  on_screen_.clear();
  seen_.clear();
  for (const LitCorner& corner : corners_) on_screen_.push_back(painter.project(corner));
  for (const auto& [a, b, c] : mesh.triangles)
    seen_.push_back(painter.paint(on_screen_[a], on_screen_[b], on_screen_[c]));
  if (!labels_) keepSoftEdges(mesh);
}

void Renderer::keepSoftEdges(const Mesh& mesh) {
  for (const Mesh::Edge& edge : mesh.edges) {
    const bool one = seen_[edge.triangles[0]];
    const bool other = edge.triangles[1] >= 0 && seen_[edge.triangles[1]];
    if (!(one != other || (one && edge.is_crease))) continue;
    const ScreenCorner& from = on_screen_[edge.from];
    const ScreenCorner& to = on_screen_[edge.to];
    edges_.push_back({{from.u, to.u}, {from.v, to.v}, {from.inverse_depth, to.inverse_depth}});
  }
}

}  // namespace nao::camera
