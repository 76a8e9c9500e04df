#include "camera/texture_sampler.h"

#include <algorithm>
#include <cmath>

namespace nao::camera {
namespace {

/// The weight of the next pixel, in 1/256, `part` of the way to it; the border between the two is
/// mixed over `size` of them.
int weightOf(double part, double size) {
  return static_cast<int>(256 * std::clamp(0.5 + (part - 0.5) / size, 0.0, 1.0) + 0.5);
}

Pixel mixed(const Texture::Level& level, double right, double down, double size) {
  const double x = std::clamp(right * level.width - 0.5, 0.0, level.width - 1.0);
  const double y = std::clamp(down * level.height - 0.5, 0.0, level.height - 1.0);
  const int column = std::min(static_cast<int>(x), std::max(0, level.width - 2));
  const int row = std::min(static_cast<int>(y), std::max(0, level.height - 2));
  const int x_weight = weightOf(x - column, size);
  const int y_weight = weightOf(y - row, size);
  const Pixel* above = &level.pixels[static_cast<std::size_t>(row) * level.width + column];
  const Pixel* below = above + (level.height > 1 ? level.width : 0);
  const int next = level.width > 1 ? 1 : 0;
  return blend(blend(above[0], above[next], x_weight), blend(below[0], below[next], x_weight),
               y_weight);
}

/// Which level fits, and how much of the next coarser one, for `size` pixels of the finest to one
/// of the picture: a logarithm that is straight between powers of two.
struct LevelMix {
  std::size_t level = 0;
  int next_weight = 0;
};
LevelMix levelFor(double size, std::size_t levels) {
  LevelMix mix;
  while (size >= 2 && mix.level + 1 < levels) {
    size /= 2;
    ++mix.level;
  }
  if (mix.level + 1 < levels && size > 1) mix.next_weight = static_cast<int>(256 * (size - 1));
  return mix;
}

}  // namespace

Pixel sampleAt(const Texture& texture, double right, double down, double size) {
  const LevelMix mix = levelFor(size, texture.levels.size());
  const Pixel fine = mixed(texture.levels[mix.level], right, down, std::clamp(size, 0.01, 1.0));
  if (mix.next_weight == 0) return fine;
  return blend(fine, mixed(texture.levels[mix.level + 1], right, down, 1), mix.next_weight);
}

Pixel sample(const Texture& texture, const LinearForm& right, const LinearForm& down,
             const LinearForm& inverse_depth, double u, double v) {
  const Texture::Level& whole = texture.levels.front();
  const double depth = 1 / inverse_depth.at(u, v);
  const double s = right.at(u, v) * depth;
  const double t = down.at(u, v) * depth;
  // How far the place on the texture moves from one pixel to the next, by the quotient rule.
  const double s_u = (right.u - s * inverse_depth.u) * depth * whole.width;
  const double t_u = (down.u - t * inverse_depth.u) * depth * whole.height;
  const double s_v = (right.v - s * inverse_depth.v) * depth * whole.width;
  const double t_v = (down.v - t * inverse_depth.v) * depth * whole.height;
  const double size = std::sqrt(std::max(s_u * s_u + t_u * t_u, s_v * s_v + t_v * t_v));
  return sampleAt(texture, s, t, size);
}

}  // namespace nao::camera
