#include "camera/renderer.h"

#include <algorithm>
#include <tuple>

#include "camera/ground_painter.h"
#include "camera/light.h"
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
auto sortKey(const Pose& X_CS, const Shape& shape) {
  const Vec3 p = X_CS.translation();
  return std::make_tuple(p.squaredNorm(), p.x(), p.y(), p.z(), shape.kind, shape.size.x(),
                         shape.size.y(), shape.size.z(), toPixel(shape.color));
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

const Raster& Renderer::render(const SceneFrame& scene, CameraPlace place, ImageSize size) {
  return renderFor(scene, viewOf(scene, place, size), place);
}

const Raster& Renderer::render(const SceneFrame& scene, const View& view) {
  return renderFor(scene, view, std::nullopt);
}

const Raster& Renderer::renderFor(const SceneFrame& scene, const View& view,
                                  std::optional<CameraPlace> own) {
  NAO_CHECK(scene.world != nullptr);
  raster_.reset(view.lens.size);
  if (!isPlausible(view.X_WC)) {
    raster_.fill(toPixel(scene.world->sky_color));
    return raster_;
  }
  const GroundForms ground(view);
  paintGround(*scene.world, ground, raster_);
  collectItems(scene, view, own);
  sortItems();
  paintItems(view, ground);
  return raster_;
}

void Renderer::collectItems(const SceneFrame& scene, const View& view,
                            std::optional<CameraPlace> own) {
  items_.clear();
  const Pose X_CW = view.X_WC.inverse();
  for (const Obstacle& obstacle : scene.world->obstacles)
    collect(obstacle.shape, X_CW * obstacle.shape.X_BS, view);
  for (const SceneFrame::Ball& ball : scene.balls) {
    Shape sphere;
    sphere.size.x() = ball.radius;
    sphere.color = ball.color;
    collect(sphere, X_CW * translation(ball.p_W), view);
  }
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const bool is_own = own && own->robot == i;
    const SceneFrame::Robot& robot = scene.robots[i];
    collectRobot(robot, view, is_own ? &robot.model->cameras[own->camera] : nullptr);
  }
}

void Renderer::collectRobot(const SceneFrame::Robot& robot, const View& view,
                            const CameraModel* own_camera) {
  const Pose X_CW = view.X_WC.inverse();
  for (std::size_t body = 0; body < robot.model->bodies.size(); ++body) {
    if (own_camera != nullptr && own_camera->body == static_cast<int>(body)) continue;
    const Pose X_CB = X_CW * robot.X_WB[body];
    for (const Shape& shape : robot.model->bodies[body].visuals) {
      const Pose X_CS = X_CB * shape.X_BS;
      const Vec3 p_SC_S = X_CS.inverse().translation();
      if (own_camera != nullptr && distanceTo(shape, p_SC_S) < kOwnClearance) continue;
      collect(shape, X_CS, view);
    }
  }
}

void Renderer::collect(const Shape& shape, const Pose& X_CS, const View& view) {
  if (mayShow(X_CS.translation(), boundingRadius(shape), view.lens))
    items_.push_back({X_CS, shape});
}

void Renderer::sortItems() {
  std::sort(items_.begin(), items_.end(), [](const Item& a, const Item& b) {
    return sortKey(a.X_CS, a.shape) < sortKey(b.X_CS, b.shape);
  });
}

void Renderer::paintItems(const View& view, const GroundForms& ground) {
  const Vec3 lamp_C = view.X_WC.linear().transpose() * towardsLamp().normalized();
  TrianglePainter triangles(view.lens, ground.inverseDepth(), raster_);
  // Near solids first: what they hide is not even coloured. Then spheres, far ones first.
  for (const Item& item : items_) {
    if (item.shape.kind == Shape::Kind::Sphere) continue;
    if (item.shape.kind == Shape::Kind::Hull) {
      paintHull(item, lamp_C, triangles);
    } else {
      paintMesh(item, lamp_C, triangles, view.lens);
    }
  }
  for (auto item = items_.rbegin(); item != items_.rend(); ++item) {
    if (item->shape.kind != Shape::Kind::Sphere) continue;
    paintSphere({item->X_CS.translation(), item->shape.size.x(), toPixel(item->shape.color)},
                view.lens, lamp_C, ground.inverseDepth(), raster_);
  }
}

void Renderer::paintMesh(const Item& item, const Vec3& lamp_C, TrianglePainter& painter,
                         const Pinhole& lens) {
  const double depth = item.X_CS.translation().x() - boundingRadius(item.shape);
  const Mesh& mesh = meshes_.find(item.shape.kind, roundnessFor(item.shape, depth, lens));
  const Stretch stretch = stretchOf(item.shape);
  const Vec3 lamp_S = item.X_CS.linear().transpose() * lamp_C;
  corners_.clear();
  for (const Mesh::Vertex& vertex : mesh.vertices) {
    const Vec3 p_S =
        stretch.scale.cwiseProduct(vertex.corner) + Vec3(0, 0, vertex.end * stretch.half_length);
    corners_.push_back({item.X_CS * p_S, lightStrength(vertex.normal.dot(lamp_S))});
  }
  const Pixel color = toPixel(item.shape.color);
  for (const auto& [a, b, c] : mesh.triangles) {
    painter.paint({corners_[a], corners_[b], corners_[c]}, color);
  }
}

void Renderer::paintHull(const Item& item, const Vec3& lamp_C, TrianglePainter& painter) {
  const Hull& hull = *item.shape.hull;
  const Vec3 lamp_S = item.X_CS.linear().transpose() * lamp_C;
  const Pixel color = toPixel(item.shape.color);
  for (const Hull::Face& face : hull.faces) {
    const double light = lightStrength(face.normal.dot(lamp_S));
    const auto corner = [&](std::size_t i) {
      const Vec3& p_S = hull.corners[static_cast<std::size_t>(face.corners[i])];
      return LitCorner{item.X_CS * p_S, light};
    };
    painter.paint({corner(0), corner(1), corner(2)}, color);
  }
}

}  // namespace nao::camera
