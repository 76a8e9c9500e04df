#include "camera/ground_painter.h"

#include <array>

#include "camera/carpet_grain.h"
#include "camera/ground_truth.h"

namespace nao::camera {
namespace {

constexpr Color kFloor{125, 120, 112};  // around the carpet; a free choice

/// The pixels whose centres lie between two columns.
struct PixelRange {
  int first = 0;
  int end = 0;
};

PixelRange toPixels(const Interval& interval, int width) {
  const double low = std::clamp(interval.low + 0.5, 0.0, static_cast<double>(width));
  const double high = std::clamp(interval.high + 0.5, 0.0, static_cast<double>(width));
  return {static_cast<int>(low), static_cast<int>(high)};
}

/// Cuts an interval down to where `form` >= bound on this row.
void cut(Interval& interval, const LinearForm& form, double row, double bound) {
  const double rest = bound - (form.v * row + form.one);
  if (form.u > 0) {
    interval.low = std::max(interval.low, rest / form.u);
  } else if (form.u < 0) {
    interval.high = std::min(interval.high, rest / form.u);
  } else if (rest > 0) {
    interval.high = interval.low - 1;
  }
}

/// `form` divided so that it counts pixels from its zero line.
LinearForm inPixels(const LinearForm& form) {
  const double slope = std::sqrt(form.u * form.u + form.v * form.v);
  return (1 / (slope + 1e-30)) * form;
}

/// A convex patch of paint between two pairs of facing edges; each form counts pixels inwards.
struct Patch {
  std::array<LinearForm, 4> edges;  // 0 faces 1, 2 faces 3
  Pixel paint = 0;
};

double patchCoverage(const Patch& patch, double u, double v) {
  const auto& e = patch.edges;
  const double across = coverage(e[0].at(u, v)) + coverage(e[1].at(u, v)) - 1;
  const double along = coverage(e[2].at(u, v)) + coverage(e[3].at(u, v)) - 1;
  return std::max(0.0, across) * std::max(0.0, along);
}

void paintEdge(const Patch& patch, int row, PixelRange range, Pixel* colors) {
  for (int i = range.first; i < range.end; ++i) {
    const int weight = static_cast<int>(256 * patchCoverage(patch, i + 0.5, row + 0.5) + 0.5);
    colors[i] = blend(colors[i], patch.paint, weight);
  }
}

/// Fills a row's pixels from one up to, not with, another.
struct PlainFill {
  Pixel paint;
  void operator()(int, int first, int end, Pixel* colors) const {
    std::fill(colors + first, colors + end, paint);
  }
};

template <class Fill>
void paintPatchRow(const Patch& patch, const LinearForm& fall, int row, Raster& raster,
                   const Fill& fill) {
  const double v = row + 0.5;
  Interval touched{0, static_cast<double>(raster.size().width)};
  cut(touched, fall, v, 0);
  Interval filled = touched;
  for (const LinearForm& edge : patch.edges) {
    cut(touched, edge, v, -0.5);
    cut(filled, edge, v, 0.5);
  }
  const PixelRange all = toPixels(touched, raster.size().width);
  if (all.first >= all.end) return;
  PixelRange solid = toPixels(filled, raster.size().width);
  if (solid.first >= solid.end) solid = {all.end, all.end};
  Pixel* const colors = raster.colors(row);
  paintEdge(patch, row, {all.first, solid.first}, colors);
  if (solid.first < solid.end) fill(row, solid.first, solid.end, colors);
  paintEdge(patch, row, {solid.end, all.end}, colors);
}

/// A rectangle on the ground: `half_length` along `direction` and `half_width` across it.
Patch makePatch(const GroundForms& ground, const Eigen::Vector2d& centre,
                const Eigen::Vector2d& direction, double half_length, double half_width) {
  const LinearForm x = ground.x - centre.x() * ground.fall;
  const LinearForm y = ground.y - centre.y() * ground.fall;
  const LinearForm along = direction.x() * x + direction.y() * y;
  const LinearForm across = direction.x() * y - direction.y() * x;
  const LinearForm length = half_length * ground.fall;
  const LinearForm width = half_width * ground.fall;
  return {{inPixels(width - across), inPixels(width + across), inPixels(length - along),
           inPixels(length + along)}};
}

void paintPatch(const Patch& patch, const LinearForm& fall, Raster& raster) {
  for (int row = 0; row < raster.size().height; ++row)
    paintPatchRow(patch, fall, row, raster, PlainFill{patch.paint});
}

void paintLine(const GroundMark& mark, const GroundForms& ground, Raster& raster) {
  const Eigen::Vector2d span = mark.to - mark.from;
  const double length = span.norm();
  const Eigen::Vector2d direction =
      length > 0 ? Eigen::Vector2d(span / length) : Eigen::Vector2d(1, 0);
  Patch patch = makePatch(ground, (mark.from + mark.to) / 2, direction, length / 2, mark.width / 2);
  patch.paint = toPixel(mark.color);
  paintPatch(patch, ground.fall, raster);
}

Conic circle(const GroundForms& ground, const Eigen::Vector2d& centre, double radius) {
  Conic conic;
  conic.addSquare(1, ground.x - centre.x() * ground.fall);
  conic.addSquare(1, ground.y - centre.y() * ground.fall);
  conic.addSquare(-radius * radius, ground.fall);
  return conic;
}

/// A ring, or a disc when there is no hole.
struct RingOutline {
  Conic outer;
  std::optional<Conic> hole;
  Pixel paint = 0;
};

/// The columns well inside the hole, where nothing is to be painted.
Interval emptyReach(const Conic& hole, int row) {
  if (!hole.isBounded()) return {0, -1};
  const std::optional<Interval> above = hole.rowInside(row - 1.0);
  const std::optional<Interval> below = hole.rowInside(row + 2.0);
  if (!above || !below) return {0, -1};
  return {std::max(above->low, below->low) + 2, std::min(above->high, below->high) - 2};
}

void paintRingPixels(const RingOutline& ring, int row, PixelRange range, Pixel* colors) {
  for (int i = range.first; i < range.end; ++i) {
    double covered = coverage(ring.outer.insideDistance(i + 0.5, row + 0.5));
    if (ring.hole) covered -= coverage(ring.hole->insideDistance(i + 0.5, row + 0.5));
    const int weight = static_cast<int>(256 * std::max(0.0, covered) + 0.5);
    if (weight > 0) colors[i] = blend(colors[i], ring.paint, weight);
  }
}

void paintRingRow(const RingOutline& ring, const LinearForm& fall, int row, Raster& raster) {
  const std::optional<Interval> reach = ring.outer.rowReach(row);
  if (!reach) return;
  Interval below_horizon{0, static_cast<double>(raster.size().width)};
  cut(below_horizon, fall, row + 0.5, 0);
  below_horizon = {std::max(below_horizon.low, reach->low),
                   std::min(below_horizon.high, reach->high)};
  const PixelRange all = toPixels(below_horizon, raster.size().width);
  PixelRange empty{all.end, all.end};
  if (ring.hole) {
    const PixelRange hole = toPixels(emptyReach(*ring.hole, row), raster.size().width);
    if (hole.first < hole.end) {
      empty = {std::clamp(hole.first, all.first, std::max(all.first, all.end)),
               std::clamp(hole.end, all.first, std::max(all.first, all.end))};
    }
  }
  paintRingPixels(ring, row, {all.first, empty.first}, raster.colors(row));
  paintRingPixels(ring, row, {empty.end, all.end}, raster.colors(row));
}

void paintRing(const GroundMark& mark, const GroundForms& ground, Raster& raster) {
  RingOutline ring;
  ring.outer = circle(ground, mark.from, mark.radius + mark.width / 2);
  const double hole_radius = mark.radius - mark.width / 2;
  if (hole_radius > 0) ring.hole = circle(ground, mark.from, hole_radius);
  ring.paint = toPixel(mark.color);
  for (int row = 0; row < raster.size().height; ++row) {
    paintRingRow(ring, ground.fall, row, raster);
  }
}

void paintSkyAndFloor(const WorldModel& world, const GroundForms& ground, Raster& raster) {
  const LinearForm horizon = inPixels(ground.fall);
  const Patch floor{{horizon, {0, 0, 1e9}, {0, 0, 1e9}, {0, 0, 1e9}}, toPixel(kFloor)};
  const LinearForm everywhere{0, 0, 1};
  for (int row = 0; row < raster.size().height; ++row) {
    Pixel* const colors = raster.colors(row);
    std::fill(colors, colors + raster.size().width, toPixel(world.sky_color));
    paintPatchRow(floor, everywhere, row, raster, PlainFill{floor.paint});
  }
}

}  // namespace

GroundForms::GroundForms(const View& view) {
  const RayForms ray = rayForms(view.lens);
  const Mat3 R_CW = view.X_WC.linear().transpose();
  const Vec3 p_W = view.X_WC.translation();
  height = std::max(p_W.z(), 1e-3);
  fall = -1.0 * alongRay(ray, R_CW.col(2));
  x = p_W.x() * fall + height * alongRay(ray, R_CW.col(0));
  y = p_W.y() * fall + height * alongRay(ray, R_CW.col(1));
}

namespace {

void paintCarpet(const WorldModel& world, const GroundForms& ground, const CarpetGrain& grain,
                 Raster& raster) {
  Patch carpet = makePatch(ground, Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitX(),
                           world.ground_size.x() / 2, world.ground_size.y() / 2);
  carpet.paint = toPixel(world.ground_color);
  if (world.ground_grain == 0) return paintPatch(carpet, ground.fall, raster);
  const auto palette = CarpetGrain::paletteOf(world.ground_color, world.ground_grain);
  const auto fill = [&](int row, int first, int end, Pixel* colors) {
    grain.fill(ground, palette, row, first, end, colors);
  };
  for (int row = 0; row < raster.size().height; ++row)
    paintPatchRow(carpet, ground.fall, row, raster, fill);
}

bool isOn(const GroundMark& mark, const Eigen::Vector2d& p) {
  const double half = mark.width / 2;
  if (mark.kind == GroundMark::Kind::Ring) {
    const double out = (p - mark.from).norm();
    return out <= mark.radius + half && out >= mark.radius - half;
  }
  const Eigen::Vector2d span = mark.to - mark.from;
  const double length = span.norm();
  const Eigen::Vector2d along = length > 0 ? Eigen::Vector2d(span / length) : Eigen::Vector2d(1, 0);
  const Eigen::Vector2d q = p - mark.from;
  const double far = along.dot(q);
  return far >= 0 && far <= length && std::abs(along.x() * q.y() - along.y() * q.x()) <= half;
}

Pixel labelAt(const WorldModel& world, const GroundForms& ground, double u, double v) {
  const double fall = ground.fall.at(u, v);
  if (fall <= 0) return kSkyLabel;
  const Eigen::Vector2d p(ground.x.at(u, v) / fall, ground.y.at(u, v) / fall);
  const auto& marks = world.marks;
  const bool is_marked = std::any_of(marks.begin(), marks.end(),
                                     [&](const GroundMark& mark) { return isOn(mark, p); });
  return is_marked ? kMarkLabel : kGroundLabel;
}

}  // namespace

void paintGroundLabels(const WorldModel& world, const GroundForms& ground, Raster& raster) {
  for (int row = 0; row < raster.size().height; ++row) {
    Pixel* const labels = raster.colors(row);
    for (int column = 0; column < raster.size().width; ++column)
      labels[column] = labelAt(world, ground, column + 0.5, row + 0.5);
  }
}

void paintGround(const WorldModel& world, const GroundForms& ground, const CarpetGrain& grain,
                 Raster& raster) {
  paintSkyAndFloor(world, ground, raster);
  paintCarpet(world, ground, grain, raster);
  for (const GroundMark& mark : world.marks) {
    switch (mark.kind) {
      case GroundMark::Kind::Line:
        paintLine(mark, ground, raster);
        break;
      case GroundMark::Kind::Ring:
        paintRing(mark, ground, raster);
        break;
    }
  }
}

}  // namespace nao::camera
