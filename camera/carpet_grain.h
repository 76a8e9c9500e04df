#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "camera/ground_painter.h"

namespace nao::camera {

/// The grain of a carpet: brightness that strays from place to place, 2 mm each, repeated every
/// half metre. From afar the mean is seen, in coarser and coarser levels.
class CarpetGrain {
 public:
  CarpetGrain();

  /// The colours of a carpet from darkest to brightest; `grain` is how far they stray, part of it.
  using Palette = std::array<Pixel, 256>;
  static Palette paletteOf(Color carpet, double grain);

  /// Fills pixels of a row that show the carpet.
  void fill(const GroundForms& ground, const Palette& palette, int row, int first, int end,
            Pixel* colors) const;

 private:
  struct Place {
    double x, y;  // [cells]
  };
  void fillBlock(const Place& from, const Place& to, double size, const Palette& palette, int count,
                 Pixel* colors) const;

  std::vector<std::vector<std::uint8_t>> levels_;  // 256 x 256 cells, then halves of it
};

}  // namespace nao::camera
