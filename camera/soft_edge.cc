#include <cmath>

#include "camera/triangle_painter.h"

namespace nao::camera {
namespace {

/// How much nearer than an edge [part of it] its own faces may be half a pixel beside it.
constexpr double kOwnDepth = 1.03;

// An edge that is steeper than 45 degrees is walked row by row, with `along` the row and `across`
// the column; a flatter one the other way round.
struct Walk {
  double along0, across0, depth0;
  double slope, depth_slope;
  int first, end;
  bool is_steep;
};

int firstCentre(double edge, int limit) {
  return static_cast<int>(std::clamp(edge + 0.5, 0.0, static_cast<double>(limit)));
}

Walk walkAlong(const SoftEdge& edge, ImageSize size) {
  const double du = edge.u[1] - edge.u[0];
  const double dv = edge.v[1] - edge.v[0];
  Walk walk{};
  walk.is_steep = std::abs(dv) >= std::abs(du);
  const double* along = walk.is_steep ? edge.v : edge.u;
  const double* across = walk.is_steep ? edge.u : edge.v;
  const int low = along[0] <= along[1] ? 0 : 1;
  const double length = along[1 - low] - along[low];
  const int limit = walk.is_steep ? size.height : size.width;
  walk.along0 = along[low];
  walk.across0 = across[low];
  walk.depth0 = edge.inverse_depth[low];
  walk.slope = (across[1 - low] - across[low]) / length;
  walk.depth_slope = (edge.inverse_depth[1 - low] - walk.depth0) / length;
  walk.first = firstCentre(along[low], limit);
  walk.end = firstCentre(along[1 - low], limit);
  return walk;
}

}  // namespace

void soften(const SoftEdge& edge, const LinearForm& ground_inverse_depth, Raster& raster) {
  const ImageSize size = raster.size();
  const Walk walk = walkAlong(edge, size);
  const int limit = walk.is_steep ? size.width : size.height;
  for (int k = walk.first; k < walk.end; ++k) {
    const double step = k + 0.5 - walk.along0;
    const double across = walk.across0 + step * walk.slope;
    if (!(across >= 0 && across < limit)) continue;
    const int mixed = static_cast<int>(across);
    const double part = across - mixed;  // of the pixel, before the edge
    // Its centre lies on the larger side, so the colour of the other side is the neighbour's.
    const int other = part > 0.5 ? mixed + 1 : mixed - 1;
    if (other < 0 || other >= limit) continue;
    const double depth = walk.depth0 + step * walk.depth_slope;
    const auto at = [&](int i) { return walk.is_steep ? std::pair(i, k) : std::pair(k, i); };
    const auto [u, v] = at(mixed);
    const auto [other_u, other_v] = at(other);
    if (depth < ground_inverse_depth.at(u + 0.5, v + 0.5)) continue;
    const double hidden = kOwnDepth * depth;
    if (raster.inverseDepths(v)[u] > hidden && raster.inverseDepths(other_v)[other_u] > hidden)
      continue;
    const double others = part > 0.5 ? 1 - part : part;
    Pixel& pixel = raster.colors(v)[u];
    pixel = blend(pixel, raster.colors(other_v)[other_u], static_cast<int>(256 * others + 0.5));
  }
}

}  // namespace nao::camera
