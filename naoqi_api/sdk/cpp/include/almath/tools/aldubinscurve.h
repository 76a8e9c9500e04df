#pragma once

#include <vector>

#include <almath/tools/almath.h>
#include <usarnaoqi_sdk/export.h>

namespace AL {
namespace Math {

/// The shortest way of an arc, a straight and an arc from (0, 0, 0) to `target`, arcs of
/// `circle_radius` [m]: the poses at the end of each part, the last of them `target`.
/// @throws std::runtime_error unless the radius is above 0.
USARNAOQI_SDK_API std::vector<Pose2D> getDubinsSolutions(const Pose2D& target, float circle_radius);

}  // namespace Math
}  // namespace AL
