#include "naoqi_api/services/ball_finder.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/check.h"
#include "naoqi_api/services/disc_fit.h"

namespace nao::services {
namespace {

constexpr int kLeastPixels = 12;  // free: less may be noise

// Red to orange, saturated and not dark: the balls of RoboCup up to 2015 and Aldebaran's.
bool isRed(const std::uint8_t* pixel) {
  const int red = pixel[0];
  const int green = pixel[1];
  const int blue = pixel[2];
  return red > 70 && red > 1.6 * green && red > 2.2 * blue;
}

/// What is red in a picture; patches are taken out of it one by one.
class RedMask {
 public:
  explicit RedMask(const camera::Image& image)
      : width_(image.size.width), height_(image.size.height), red_(countOf(image.size)) {
    for (std::size_t i = 0; i < red_.size(); ++i)
      red_[i] = isRed(&(*image.bytes)[3 * i]) ? kRed : kNot;
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool isNew(int x, int y) const { return at(x, y) == kRed; }

  /// The red pixels that hang together with this one.
  PatchShape take(int x, int y) {
    PatchShape patch{{}, 0, width_, height_};
    std::vector<std::pair<int, int>> open = {{x, y}};
    red_[index(x, y)] = kTaken;
    while (!open.empty()) {
      const auto [px, py] = open.back();
      open.pop_back();
      ++patch.count;
      for (const auto& [dx, dy] : kNeighbours) look(px, py, dx, dy, patch, open);
    }
    return patch;
  }

 private:
  enum : char { kNot, kRed, kTaken };
  static constexpr std::array<std::pair<int, int>, 4> kNeighbours = {
      {{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

  static std::size_t countOf(camera::ImageSize size) {
    return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
  }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }
  char at(int x, int y) const { return red_[index(x, y)]; }

  void look(int x, int y, int dx, int dy, PatchShape& patch,
            std::vector<std::pair<int, int>>& open) {
    const int to_x = x + dx;
    const int to_y = y + dy;
    if (to_x < 0 || to_y < 0 || to_x >= width_ || to_y >= height_) return;
    if (at(to_x, to_y) == kNot) {
      patch.border.push_back({x + 0.5 + 0.5 * dx, y + 0.5 + 0.5 * dy});
    } else if (at(to_x, to_y) == kRed) {
      red_[index(to_x, to_y)] = kTaken;
      open.emplace_back(to_x, to_y);
    }
  }

  int width_;
  int height_;
  std::vector<char> red_;
};

}  // namespace

std::optional<SeenBall> findRedBall(const camera::Image& image) {
  NAO_CHECK(image.color_space == camera::ColorSpace::kRGB);
  RedMask red(image);
  std::optional<Disc> best;
  int best_count = kLeastPixels - 1;
  for (int y = 0; y < red.height(); ++y) {
    for (int x = 0; x < red.width(); ++x) {
      if (!red.isNew(x, y)) continue;
      PatchShape patch = red.take(x, y);
      const int count = patch.count;
      if (count <= best_count) continue;
      const auto disc = fitDisc(std::move(patch));
      if (!disc) continue;
      best = disc;
      best_count = count;
    }
  }
  if (!best) return std::nullopt;
  return SeenBall{best->x / red.width(), best->y / red.height(), 2 * best->radius / red.width()};
}

}  // namespace nao::services
