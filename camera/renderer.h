#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "camera/carpet_grain.h"
#include "camera/led_lights.h"
#include "camera/mesh.h"
#include "camera/raster.h"
#include "camera/shadow_painter.h"
#include "camera/triangle_painter.h"
#include "camera/view.h"
#include "core/scene_frame.h"

namespace nao::camera {

/// The camera that looks, and whose own head must not stand in its way.
struct CameraPlace {
  std::size_t robot = 0;   // index into SceneFrame::robots
  std::size_t camera = 0;  // index into RobotModel::cameras
};

/// Draws scenes in software: sky, carpet and its lines, shadows, robots, obstacles, balls. The
/// same scene and place give the same pixels on every machine, in whatever order the scene lists
/// its things. Not thread-safe: one Renderer per thread; it keeps its buffers from picture to
/// picture.
class Renderer {
 public:
  /// What this camera of the scene sees through its pinhole. The result is good until the next
  /// call; until then it is the caller's to change.
  Raster& render(const SceneFrame& scene, CameraPlace place, ImageSize size);

  /// The same through another lens.
  Raster& render(const SceneFrame& scene, CameraPlace place, const View& view);

  /// What a camera that belongs to nobody sees from here.
  Raster& render(const SceneFrame& scene, const View& view);

  /// The same places of the same scene as labels (camera/ground_truth.h) in place of colours:
  /// nothing is lit or softened.
  Raster& renderLabels(const SceneFrame& scene, std::optional<CameraPlace> own, const View& view);

 private:
  /// A shape that may be in view, where, and how it is painted.
  struct Item {
    Pose X_CS = Pose::Identity();
    const Shape* shape = nullptr;
    Pixel color = 0;
    bool is_above_ground = false;
    bool glows = false;        // by itself: no light falls on it
    bool has_patches = false;  // a soccer ball
  };

  Raster& renderFor(const SceneFrame& scene, const View& view, std::optional<CameraPlace> own);
  void collectItems(const SceneFrame& scene, const View& view, std::optional<CameraPlace> own);
  void collectRobot(const SceneFrame::Robot& robot, Pixel label, const View& view,
                    const CameraModel* own_camera);
  void collectLights(const SceneFrame::Robot& robot, Pixel label, const View& view, int own_head);
  void collectBall(const SceneFrame::Ball& ball, Pixel label, const View& view);
  void collect(Item item, const Pose& X_WS, const View& view);
  void sortItems();
  Thing thingOf(const Item& item) const;  // by its place among the sorted ones
  void paintItems(const View& view, const GroundForms& ground);
  void paintMesh(const Item& item, const Vec3& lamp_C, TrianglePainter& painter,
                 const Pinhole& lens);
  void placeCorners(const Item& item, const Mesh& mesh, const Vec3& lamp_C);
  void paintSeen(const Mesh& mesh, TrianglePainter& painter);
  void keepSoftEdges(const Mesh& mesh);

  MeshLibrary meshes_;
  LedLights lights_;
  CarpetGrain grain_;
  Raster raster_;
  bool labels_ = false;  // in place of colours
  std::vector<Item> items_;
  std::deque<Shape> made_;  // shapes of balls and lights
  std::vector<Shadow> shadows_;
  std::vector<LitCorner> corners_;
  std::vector<ScreenCorner> on_screen_;
  std::vector<char> seen_;  // by triangle of a mesh: from the front
  std::vector<SoftEdge> edges_;
};

/// Where this camera is and how it looks at the world.
View viewOf(const SceneFrame& scene, CameraPlace place, ImageSize size);

}  // namespace nao::camera
