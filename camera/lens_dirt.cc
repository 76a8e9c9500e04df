#include "camera/lens_dirt.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace nao::camera {
namespace {

constexpr int kOpaque = 256;
constexpr std::uint32_t kScattered = 180;  // of the mean light, in 1/256; free choice

// Where the blotches lie, in 1/1024 of the picture's width from its middle. Free choice: in all
// parts of it, and with clear places between them.
struct Blotch {
  int x, y, radius;
};
constexpr Blotch kBlotches[] = {{-330, -210, 180}, {-60, -120, 210}, {250, -220, 160},
                                {-400, 90, 150},   {-150, 150, 190}, {90, 60, 170},
                                {340, 40, 200},    {210, 280, 180},  {-300, 320, 160}};

// How opaque a place is when half of the dirt is there, 0 to 256.
int patternAt(int x, int y) {
  int most = 0;
  for (const Blotch& blotch : kBlotches) {
    const int dx = x - blotch.x;
    const int dy = y - blotch.y;
    const int square = blotch.radius * blotch.radius;
    most = std::max(most, kOpaque - kOpaque * (dx * dx + dy * dy) / square);
  }
  return most;
}

Pixel scatteredLight(const Raster& picture) {
  std::array<std::uint64_t, 3> sum{};
  const ImageSize size = picture.size();
  for (int row = 0; row < size.height; ++row) {
    const Pixel* colors = picture.colors(row);
    for (int column = 0; column < size.width; ++column) {
      for (unsigned c = 0; c < 3; ++c) sum[c] += colors[column] >> 8 * c & 0xffU;
    }
  }
  const auto count = static_cast<std::uint64_t>(size.width) * static_cast<unsigned>(size.height);
  Pixel mean = 0;
  for (unsigned c = 0; c < 3; ++c) {
    mean |= static_cast<Pixel>(sum[c] / count * kScattered / 256) << 8 * c;
  }
  return mean;
}

}  // namespace

void layDirt(Raster& picture, float dirt) {
  if (!(dirt > 0)) return;
  const ImageSize size = picture.size();
  const Pixel veil = scatteredLight(picture);
  const int more = static_cast<int>(2 * kOpaque * std::min(dirt, 1.0F)) - kOpaque;
  for (int row = 0; row < size.height; ++row) {
    Pixel* colors = picture.colors(row);
    const int y = (2 * row - size.height) * 512 / size.width;
    for (int column = 0; column < size.width; ++column) {
      const int x = (2 * column - size.width) * 512 / size.width;
      const int opacity = std::clamp(patternAt(x, y) + more, 0, kOpaque);
      if (opacity > 0) colors[column] = blend(colors[column], veil, opacity);
    }
  }
}

}  // namespace nao::camera
