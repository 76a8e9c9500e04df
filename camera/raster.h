#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "camera/image.h"
#include "core/shape.h"

namespace nao::camera {

/// A colour in one word: red in the lowest byte, then green, then blue.
using Pixel = std::uint32_t;

constexpr Pixel toPixel(Color color) {
  return static_cast<Pixel>(color.red) | static_cast<Pixel>(color.green) << 8 |
         static_cast<Pixel>(color.blue) << 16;
}

/// `paint` laid over `under`; weight 0 (nothing) to 256 (opaque).
constexpr Pixel blend(Pixel under, Pixel paint, int weight) {
  const std::uint32_t w = static_cast<std::uint32_t>(weight);
  const std::uint32_t even = (under & 0xff00ffu) * (256 - w) + (paint & 0xff00ffu) * w + 0x800080u;
  const std::uint32_t odd = (under & 0xff00u) * (256 - w) + (paint & 0xff00u) * w + 0x8000u;
  return (even >> 8 & 0xff00ffu) | (odd >> 8 & 0xff00u);
}

/// `color` under a light of strength 0 (black) to 256 (as it is).
constexpr Pixel lit(Pixel color, int strength) { return blend(0, color, strength); }

/// What a pixel shows: the number of a solid, or ground or sky.
using Thing = std::uint16_t;
inline constexpr Thing kGround = 0;
inline constexpr Thing kRim = 0xffff;  // of a sphere, mixed already

/// A picture in the making: colour, inverse depth [1/m] along the line of sight and thing of each
/// pixel. Inverse depth 0 is infinitely far. Pixel (column, row) covers [column, column + 1) in u,
/// and the same in v; the origin is the upper left corner.
class Raster {
 public:
  /// Takes on a size and forgets the old depths; colours are left to whoever paints first.
  void reset(ImageSize size) {
    size_ = size;
    const std::size_t count = static_cast<std::size_t>(size.width) * size.height;
    colors_.resize(count);
    inverse_depths_.assign(count, 0.0f);
    things_.assign(count, kGround);
  }

  void fill(Pixel color) { std::fill(colors_.begin(), colors_.end(), color); }

  ImageSize size() const { return size_; }
  Pixel* colors(int row) { return colors_.data() + offset(row); }
  const Pixel* colors(int row) const { return colors_.data() + offset(row); }
  float* inverseDepths(int row) { return inverse_depths_.data() + offset(row); }
  const float* inverseDepths(int row) const { return inverse_depths_.data() + offset(row); }
  Thing* things(int row) { return things_.data() + offset(row); }
  const Thing* things(int row) const { return things_.data() + offset(row); }

 private:
  std::size_t offset(int row) const { return static_cast<std::size_t>(row) * size_.width; }

  ImageSize size_;
  std::vector<Pixel> colors_;
  std::vector<float> inverse_depths_;
  std::vector<Thing> things_;
};

}  // namespace nao::camera
