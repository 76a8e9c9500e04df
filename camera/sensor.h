#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "camera/camera_settings.h"
#include "camera/raster.h"
#include "camera/sensor_type.h"

namespace nao::camera {

/// How far automatic exposure has come, and what the last picture was taken with.
struct Adaptation {
  std::optional<SimTime> looked;  // when automatic exposure last looked
  double signal = 1;              // what it has come to
  double exposure = 0;            // [s]
  double gain = 1;
  int brightness = 0;  // mean that was metered, 0 to 255
};

/// Light and colour as a camera of a robot takes them in: exposure, gain and white balance, set or
/// automatic, the fall-off to the corners, noise. It keeps how far automatic exposure has come, by
/// simulated time; the same scenes at the same times give the same pictures. Whole numbers
/// throughout, but for a few factors a picture.
class Sensor {
 public:
  Sensor(const SensorType& type, const CameraEffects& effects, std::uint64_t seed)
      : type_(type), effects_(effects), seed_(seed) {}

  /// Turns the picture that a pinhole shows into the one that the camera gives. `light`: that of
  /// the world, by that of a usual hall. Several sizes may be exposed at one time.
  void expose(Raster& picture, const CameraSettings& settings, double light, SimTime time);

  void use(const CameraEffects& effects);

  /// Of the last picture, for its readers.
  double exposure() const { return state_.exposure; }  // [s]
  double gain() const { return state_.gain; }
  int brightness() const { return state_.brightness; }  // mean that was metered, 0 to 255

  /// All that goes on from picture to picture.
  const Adaptation& state() const { return state_; }
  void restore(const Adaptation& state) { state_ = state; }

 private:
  /// What happens to every pixel.
  struct Response {
    std::uint16_t channel[4] = {0, 0, 0, 0};  // factor, in 1/4096; red, green, blue, nothing
    int black = 0;
    int slope = 256;                   // of contrast about the middle, in 1/256
    int chroma[4] = {256, 0, 0, 256};  // what (red - y, blue - y) become, in 1/256
    bool turns_color = false;
    int noise = 0;  // standard deviation, in 1/16
  };

  void adapt(const Raster& picture, const CameraSettings& settings, double light, SimTime time);
  Response responseFor(ImageSize size, const CameraSettings& settings, double light) const;
  void fallOff(ImageSize size);
  void makeNoise(int deviation);
  void applyTo(Raster& picture, const Response& response, SimTime time);

  const SensorType& type_;
  CameraEffects effects_;
  std::uint64_t seed_;

  Adaptation state_;

  ImageSize fall_off_size_;
  std::vector<std::uint16_t> column_loss_;  // by byte of a row, in 1/65536
  std::vector<std::uint16_t> row_light_;    // by row, in 1/65536
  int noise_deviation_ = -1;                // of the noise at hand, in 1/16
  std::vector<std::int16_t> noise_;         // of which every row takes another part
};

/// The picture as flipped by the parameters of that name.
void flip(Raster& picture, bool horizontally, bool vertically);

}  // namespace nao::camera
