#include "camera/carpet_grain.h"

#include <cmath>

namespace nao::camera {
namespace {

constexpr int kCells = 256;        // a side; a power of two
constexpr int kLevels = 9;         // down to one cell
constexpr double kCell = 0.002;    // [m] free choice: tufts
constexpr int kBlock = 16;         // pixels between exact places; straight in between
constexpr double kFarthest = 1e6;  // [cells] beyond 2 km there is no grain

/// Scrambles a number (the finaliser of MurmurHash3, public domain).
std::uint32_t scrambled(std::uint32_t h) {
  h = (h ^ h >> 16) * 0x85ebca6bu;
  h = (h ^ h >> 13) * 0xc2b2ae35u;
  return h ^ h >> 16;
}

std::vector<std::uint8_t> halved(const std::vector<std::uint8_t>& fine, int side) {
  std::vector<std::uint8_t> coarse;
  for (int row = 0; row < side; row += 2) {
    for (int column = 0; column < side; column += 2) {
      const std::uint8_t* at = &fine[static_cast<std::size_t>(row) * side + column];
      coarse.push_back(
          static_cast<std::uint8_t>((at[0] + at[1] + at[side] + at[side + 1] + 2) / 4));
    }
  }
  return coarse;
}

}  // namespace

CarpetGrain::CarpetGrain() {
  std::vector<std::uint8_t> finest;
  for (std::uint32_t i = 0; i < kCells * kCells; ++i) {
    // The mean of two, so that the middle is likelier than the ends.
    const std::uint32_t noise = scrambled(i + 1);
    finest.push_back(static_cast<std::uint8_t>(((noise & 0xff) + (noise >> 8 & 0xff)) / 2));
  }
  levels_.push_back(finest);
  for (int side = kCells; side > 1; side /= 2) levels_.push_back(halved(levels_.back(), side));
}

CarpetGrain::Palette CarpetGrain::paletteOf(Color carpet, double grain) {
  Palette palette;
  for (int i = 0; i < 256; ++i) {
    const double strength = 1 + grain * (i - 127.5) / 127.5;
    const auto stray = [&](int channel) {
      return static_cast<std::uint8_t>(std::min(255.0, channel * strength + 0.5));
    };
    palette[i] = toPixel({stray(carpet.red), stray(carpet.green), stray(carpet.blue)});
  }
  return palette;
}

void CarpetGrain::fill(const GroundForms& ground, const Palette& palette, int row, int first,
                       int end, Pixel* colors) const {
  const double v = row + 0.5;
  const auto placeAt = [&](int column) {
    const double u = column + 0.5;
    const double scale = 1 / (kCell * std::max(ground.fall.at(u, v), 1e-12));
    return Place{std::clamp(ground.x.at(u, v) * scale, -kFarthest, kFarthest),
                 std::clamp(ground.y.at(u, v) * scale, -kFarthest, kFarthest)};
  };
  Place from = placeAt(first);
  for (int column = first; column < end; column += kBlock) {
    const int count = std::min(kBlock, end - column);
    const Place to = placeAt(column + count);
    const double scale = 1 / std::max(ground.fall.at(column + 0.5, v), 1e-12);
    // One row down, by the quotient rule.
    const double down_x = (ground.x.v / kCell - from.x * ground.fall.v) * scale;
    const double down_y = (ground.y.v / kCell - from.y * ground.fall.v) * scale;
    const double side_x = (to.x - from.x) / count, side_y = (to.y - from.y) / count;
    const double size =
        std::max(down_x * down_x + down_y * down_y, side_x * side_x + side_y * side_y);
    fillBlock(from, to, size, palette, count, colors + column);
    from = to;
  }
}

void CarpetGrain::fillBlock(const Place& from, const Place& to, double size, const Palette& palette,
                            int count, Pixel* colors) const {
  int level = 0;
  while (size > 2 && level + 1 < kLevels) {  // size is squared: 2 is 1.4 cells
    size /= 4;
    ++level;
  }
  const std::vector<std::uint8_t>& cells = levels_[static_cast<std::size_t>(level)];
  // 1/256 of a cell of the finest level; negative places wrap around as they should.
  int x = static_cast<int>(std::floor(from.x * 256)),
      y = static_cast<int>(std::floor(from.y * 256));
  const int dx = static_cast<int>((to.x - from.x) * 256 / count);
  const int dy = static_cast<int>((to.y - from.y) * 256 / count);
  const int mask = (kCells >> level) - 1;
  const int side_bits = 8 - level;
  for (int i = 0; i < count; ++i) {
    const int cell = (y >> (8 + level) & mask) << side_bits | (x >> (8 + level) & mask);
    colors[i] = palette[cells[static_cast<std::size_t>(cell)]];
    x += dx;
    y += dy;
  }
}

}  // namespace nao::camera
