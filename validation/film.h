#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "camera/renderer.h"
#include "core/scene_frame.h"

namespace nao::validation {

/// Draws the first robot of a scene from outside: from its front left, above its head, looking at
/// the middle of its body, which it follows over the floor.
class OutsideCamera {
 public:
  explicit OutsideCamera(camera::ImageSize size) : size_(size) {}

  /// Good until the next call.
  const camera::Raster& picture(const SceneFrame& scene);

 private:
  camera::ImageSize size_;
  camera::Renderer renderer_;
};

/// A film of a motion, 25 pictures a second: a file that ends in .mp4, or a folder of
/// frame_00000.png and so on.
class Film {
 public:
  static constexpr double kFps = 25;
  static constexpr camera::ImageSize kSize{640, 480};

  /// `encoder`: the program that writes films (tools/encode_video.cc). @throws InputError if the
  /// target can not be written, or is a film without that program.
  Film(const std::string& target, const std::string& encoder);
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Whether a picture is due at `time` [s] of the film; it is then to be added.
  bool isDue(double time) const { return time * kFps >= count_ - 1e-6; }
  void add(const SceneFrame& scene);

  /// Ends the file. @throws InputError if not all of it could be written.
  void close();
  int pictures() const { return count_; }

 private:
  void addToFolder(const camera::Raster& picture);
  void addToPipe(const camera::Raster& picture);

  std::string target_;
  OutsideCamera camera_{kSize};
  std::FILE* pipe_ = nullptr;  // of the encoder
  int count_ = 0;
};

}  // namespace nao::validation
