#pragma once

#include <optional>
#include <vector>

#include "camera/mesh.h"
#include "camera/raster.h"
#include "camera/triangle_painter.h"
#include "camera/view.h"
#include "core/scene_frame.h"

namespace nao::camera {

/// The camera that looks, and whose own head must not stand in its way.
struct CameraPlace {
  std::size_t robot = 0;   // index into SceneFrame::robots
  std::size_t camera = 0;  // index into RobotModel::cameras
};

/// Draws scenes in software: sky, carpet and its lines, robots, obstacles, balls. The same scene
/// and place give the same pixels on every machine, in whatever order the scene lists its things.
/// Not thread-safe: one Renderer per thread; it keeps its buffers from picture to picture.
class Renderer {
 public:
  /// What this camera of the scene sees. The result is good until the next call.
  const Raster& render(const SceneFrame& scene, CameraPlace place, ImageSize size);

  /// What a camera that belongs to nobody sees from here.
  const Raster& render(const SceneFrame& scene, const View& view);

 private:
  /// A shape that may be in view, and where.
  struct Item {
    Pose X_CS = Pose::Identity();
    Shape shape;
  };

  void collectItems(const SceneFrame& scene, const View& view, std::optional<CameraPlace> own);
  void collectRobot(const SceneFrame::Robot& robot, const View& view,
                    const CameraModel* own_camera);
  void collect(const Shape& shape, const Pose& X_CS, const View& view);
  void sortItems();
  void paintItems(const View& view, const GroundForms& ground);
  void paintMesh(const Item& item, const Vec3& lamp_C, TrianglePainter& painter,
                 const Pinhole& lens);
  void paintHull(const Item& item, const Vec3& lamp_C, TrianglePainter& painter);
  const Raster& renderFor(const SceneFrame& scene, const View& view,
                          std::optional<CameraPlace> own);

  MeshLibrary meshes_;
  Raster raster_;
  std::vector<Item> items_;
  std::vector<LitCorner> corners_;
};

/// Where this camera is and how it looks at the world.
View viewOf(const SceneFrame& scene, CameraPlace place, ImageSize size);

}  // namespace nao::camera
