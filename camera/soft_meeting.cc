#include "camera/soft_meeting.h"

#include <cmath>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

// Inverse depth is linear over the picture on a plane. Where two planes meet, the nearer one wins
// on either side of the line D = 0, D = one's inverse depth less the other's. On a pixel that shows
// A beside one that shows B, D comes from their own inverse depths and slopes: D >= 0 there, D < 0
// on the other, and D / |its slope| is how far the line is from the first one's centre. What merely
// hides another thing would still be nearer on the neighbour's pixel.

namespace nao::camera {
namespace {

struct Place {
  int column = 0;
  int row = 0;
};
Place operator+(Place a, Place b) { return {a.column + b.column, a.row + b.row}; }

/// A plane near one pixel: its inverse depth there and how it changes to the right and down.
struct Plane {
  double here = 0;
  double right = 0;
  double down = 0;

  double at(int columns, int rows) const { return here + columns * right + rows * down; }
};

class Meetings {
 public:
  Meetings(const LinearForm& ground, Raster& raster)
      : ground_(ground), raster_(raster), size_(raster.size()) {}

  void soften() {
    for (int row = 1; row + 1 < size_.height; ++row) look(row);
    for (const auto& [color, mixed] : mixed_) *color = mixed;
  }

 private:
  Thing thing(Place p) const { return raster_.things(p.row)[p.column]; }

  // Most pixels are like their neighbours: four at a time.
  void look(int row) {
    const Thing* const above = raster_.things(row - 1);
    const Thing* const here = raster_.things(row);
    const Thing* const below = raster_.things(row + 1);
    for (int column = 1; column + 4 < size_.width; column += 4) {
      const auto four = [column](const Thing* things, int shift) {
        std::uint64_t word = 0;
        std::memcpy(&word, things + column + shift, sizeof word);
        return word;
      };
      const std::uint64_t own = four(here, 0);
      if (own == four(here, -1) && own == four(here, 1) && own == four(above, 0) &&
          own == four(below, 0))
        continue;
      for (int i = 0; i < 4; ++i) look(Place{column + i, row});
    }
  }

  void look(Place p) {
    const Thing own = thing(p);
    if (own == kRim) return;
    for (const Place step : {Place{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      const Thing other = thing(p + step);
      if (other == own || other == kRim || isGap(p, p + step)) continue;
      if (mix(p, step)) return;
    }
  }

  /// Whether two neighbours are too far from each other to meet between them: on a surface so
  /// slanted that depth changes by a twentieth from pixel to pixel there is nothing to see.
  bool isGap(Place p, Place q) const {
    const double one = nearnessOf(p), other = nearnessOf(q);
    return std::abs(one - other) > 0.05 * one;
  }
  double nearnessOf(Place p) const {
    return thing(p) == kGround ? ground_.at(p.column + 0.5, p.row + 0.5) : solidNearness(p);
  }

  bool mix(Place p, Place step) {
    const std::optional<Plane> a = planeAt(p);
    const std::optional<Plane> b = planeAt(p + step);
    if (!a || !b) return false;
    const Plane difference{a->here - b->at(-step.column, -step.row), a->right - b->right,
                           a->down - b->down};
    const bool is_across = std::abs(difference.right) >= std::abs(difference.down);
    if (is_across != (step.column != 0)) return false;
    if (!(difference.here >= 0 && difference.at(step.column, step.row) < 0)) return false;
    const double slope =
        std::sqrt(difference.right * difference.right + difference.down * difference.down);
    const double others = 1 - coverage(difference.here / slope);
    if (others <= 0) return true;
    const Place q = p + step;
    Pixel& color = raster_.colors(p.row)[p.column];
    const Pixel beside = raster_.colors(q.row)[q.column];
    mixed_.emplace_back(&color, blend(color, beside, static_cast<int>(256 * others + 0.5)));
    return true;
  }

  double solidNearness(Place p) const { return double{raster_.inverseDepths(p.row)[p.column]}; }

  std::optional<Plane> planeAt(Place p) const {
    if (thing(p) == kGround) return Plane{nearnessOf(p), ground_.u, ground_.v};
    const auto right = slopeAt(p, {1, 0});
    const auto down = slopeAt(p, {0, 1});
    if (!right || !down) return std::nullopt;
    return Plane{solidNearness(p), *right, *down};
  }

  // From a neighbour that shows the same thing.
  std::optional<double> slopeAt(Place p, Place step) const {
    for (const int sign : {1, -1}) {
      const Place q{p.column + sign * step.column, p.row + sign * step.row};
      const bool is_inside =
          q.column >= 0 && q.column < size_.width && q.row >= 0 && q.row < size_.height;
      if (is_inside && thing(q) == thing(p)) return sign * (solidNearness(q) - solidNearness(p));
    }
    return std::nullopt;
  }

  const LinearForm& ground_;
  Raster& raster_;
  ImageSize size_;
  std::vector<std::pair<Pixel*, Pixel>> mixed_;
};

}  // namespace

void softenMeetings(const LinearForm& ground_inverse_depth, Raster& raster) {
  Meetings(ground_inverse_depth, raster).soften();
}

}  // namespace nao::camera
