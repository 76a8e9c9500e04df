#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "camera/camera_settings.h"
#include "camera/image.h"
#include "core/latest.h"

namespace nao::camera {

/// What a client wants to see. The camera must exist and offer the size and the rate.
struct ImageRequest {
  int camera = 0;  // index into RobotModel::cameras
  ImageSize size{320, 240};
  ColorSpace color_space = ColorSpace::kYUV422;
  int frame_rate = 5;  // [1/s]
};

/// A request that is being served, and the window its newest picture appears in.
struct Subscription {
  std::uint64_t id = 0;
  ImageRequest request;
  std::shared_ptr<Latest<Image>> window;
};

/// What users have set of one camera.
struct CameraControl {
  CameraSettings settings;
  std::optional<CameraEffects> effects;  // in place of those of the robot's file
};

/// The pictures of one robot, as its services see them: who wants which, and the newest of each.
/// It knows no scene; RenderQueue (camera/render_queue.h) fills it. Pictures are due at simulated
/// times k / frame_rate and, so that nobody waits long for the first one, on the step after
/// subscribe(). subscribe() and unsubscribe() belong to one thread, that of the services; the rest
/// may be called from any.
class ImageFeed {
 public:
  /// A wish can not be altered; unsubscribe and subscribe again.
  std::uint64_t subscribe(const ImageRequest& request);

  /// False if there is no such subscription.
  bool unsubscribe(std::uint64_t id);

  /// Of a camera; holds for the pictures due from now on. Same thread.
  void setSettings(int camera, const CameraSettings& settings);
  void setEffects(int camera, const CameraEffects& effects);

  /// By camera; null while nobody ever set any, and shorter where the last ones are as they were.
  std::shared_ptr<const std::vector<CameraControl>> controls() const { return controls_.get(); }

  /// The newest picture, or null before the first one and for an unknown subscription.
  std::shared_ptr<const Image> latest(std::uint64_t id) const;

  /// All of them, by ascending id; null while nobody ever subscribed.
  std::shared_ptr<const std::vector<Subscription>> subscriptions() const { return table_.get(); }

 private:
  std::vector<Subscription> own_;  // of the services' thread; published whenever it changes
  std::uint64_t next_id_ = 1;
  CameraControl& ownControl(int camera);

  std::vector<CameraControl> own_controls_;  // of the services' thread
  Latest<std::vector<CameraControl>> controls_;
  Latest<std::vector<Subscription>> table_;
};

}  // namespace nao::camera
