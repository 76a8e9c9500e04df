#pragma once

#include <vector>

#include <Eigen/Core>

namespace nao::motion {

using Polygon = std::vector<Eigen::Vector2d>;  // [m] counter-clockwise corners

/// The convex hull of points in a plane. (Andrew's monotone chain)
Polygon calcHull(std::vector<Eigen::Vector2d> points);

/// Every edge moved inwards by `margin` [m]; empty if nothing is left.
Polygon shrink(const Polygon& polygon, double margin);

/// The centre of its area.
Eigen::Vector2d centreOf(const Polygon& polygon);

/// How deep inside the nearest edge a point is [m]; negative outside.
double depthIn(const Polygon& polygon, const Eigen::Vector2d& point);

}  // namespace nao::motion
