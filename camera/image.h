#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/sim_time.h"

namespace nao::camera {

/// NaoQi's colour spaces, with NaoQi's numbers. The single-letter ones hold the capital's channel.
/// Bytes in memory: YUV422 is Y U Y V for two pixels, YYCbCr is Y Y Cb Cr for two pixels.
enum class ColorSpace {
  kYuv = 0,
  kyUv = 1,
  kyuV = 2,
  kRgb = 3,
  krGb = 4,
  krgB = 5,
  kHsy = 6,
  khSy = 7,
  khsY = 8,
  kYUV422 = 9,
  kYUV = 10,
  kRGB = 11,
  kHSY = 12,
  kBGR = 13,
  kYYCbCr = 14,
  kH2RGB = 15,   // red, green, blue of the hue alone, at its fullest and brightest
  kHSMixed = 16  // hue, saturation, and the mean of both
};

/// The colour space of this NaoQi number, or nothing for one that is not offered.
std::optional<ColorSpace> toColorSpace(int id);

/// Bytes per pixel: 1, 2 or 3 (NaoQi's "layers").
int layers(ColorSpace space);

/// Width and height of a picture [px].
struct ImageSize {
  int width = 0;
  int height = 0;
};
inline bool operator==(const ImageSize& a, const ImageSize& b) {
  return a.width == b.width && a.height == b.height;
}
inline bool operator!=(const ImageSize& a, const ImageSize& b) { return !(a == b); }

/// The size of this NaoQi resolution number (0 kQQVGA, 1 kQVGA, 2 kVGA, 3 k4VGA, 4 k16VGA,
/// 7 kQQQVGA, 8 kQQQQVGA), or nothing: the 16:9 ones belong to cameras a Nao has not.
std::optional<ImageSize> resolutionSize(int id);

/// The NaoQi resolution number of this size, or nothing.
std::optional<int> resolutionOf(ImageSize size);

using Bytes = std::vector<std::uint8_t>;

/// One picture as a client gets it. A value: copies share the same immutable bytes.
struct Image {
  ImageSize size;
  ColorSpace color_space = ColorSpace::kRGB;
  SimTime time{};                      // of the scene it shows
  int camera = 0;                      // index into RobotModel::cameras
  std::shared_ptr<const Bytes> bytes;  // rows from the top, width * layers bytes each

  /// A number that two different pictures are most unlikely to share (FNV-1a of the bytes).
  std::uint64_t hash() const;
};

}  // namespace nao::camera
