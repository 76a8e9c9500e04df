#include "naoqi_api/services/ball_finder.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/check.h"

namespace nao::services {
namespace {

constexpr int kLeastPixels = 12;     // free: less may be noise
constexpr double kRoundness = 0.45;  // free: of the bounding box, a disc fills 0.785
constexpr double kLongest = 2.0;     // free: width to height, a ball at the edge is cut

// Red to orange, saturated and not dark: the balls of RoboCup up to 2015 and Aldebaran's.
bool isRed(const std::uint8_t* pixel) {
  const int red = pixel[0];
  const int green = pixel[1];
  const int blue = pixel[2];
  return red > 70 && red > 1.6 * green && red > 2.2 * blue;
}

struct Patch {
  int count = 0;
  int left = 0, right = 0, top = 0, bottom = 0;

  int width() const { return right - left + 1; }
  int height() const { return bottom - top + 1; }
  bool isRound() const {
    const double longer = std::max(width(), height());
    const double shorter = std::min(width(), height());
    return count >= kLeastPixels && longer / shorter < kLongest &&
           count > kRoundness * width() * height();
  }
};

// The red pixels that hang together with this one; they are taken out of the mask.
Patch takePatch(std::vector<char>& red, camera::ImageSize size, int x, int y) {
  Patch patch{0, x, x, y, y};
  std::vector<std::pair<int, int>> open = {{x, y}};
  red[static_cast<std::size_t>(y * size.width + x)] = 0;
  while (!open.empty()) {
    const auto [px, py] = open.back();
    open.pop_back();
    ++patch.count;
    patch.left = std::min(patch.left, px);
    patch.right = std::max(patch.right, px);
    patch.top = std::min(patch.top, py);
    patch.bottom = std::max(patch.bottom, py);
    for (const auto& [dx, dy] :
         {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
      const int nx = px + dx;
      const int ny = py + dy;
      if (nx < 0 || ny < 0 || nx >= size.width || ny >= size.height) continue;
      char& pixel = red[static_cast<std::size_t>(ny * size.width + nx)];
      if (pixel == 0) continue;
      pixel = 0;
      open.emplace_back(nx, ny);
    }
  }
  return patch;
}

}  // namespace

std::optional<SeenBall> findRedBall(const camera::Image& image) {
  NAO_CHECK(image.color_space == camera::ColorSpace::kRGB);
  const camera::ImageSize size = image.size;
  const auto count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  std::vector<char> red(count);
  for (std::size_t i = 0; i < count; ++i) red[i] = isRed(&(*image.bytes)[3 * i]) ? 1 : 0;
  Patch best;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      if (red[static_cast<std::size_t>(y * size.width + x)] == 0) continue;
      const Patch patch = takePatch(red, size, x, y);
      if (patch.isRound() && patch.count > best.count) best = patch;
    }
  }
  if (best.count == 0) return std::nullopt;
  const double diameter = std::max(best.width(), best.height());
  return SeenBall{0.5 * (best.left + best.right + 1) / size.width,
                  0.5 * (best.top + best.bottom + 1) / size.height, diameter / size.width};
}

}  // namespace nao::services
