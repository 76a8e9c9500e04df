#include <almath/tools/aldubinscurve.h>

#include <optional>

// Dubins, "On Curves of Minimal Length with a Constraint on Average Curvature" (1957): among ways
// without a third arc the shortest is one of left or right, straight, left or right.

namespace AL::Math {
namespace {

// A way: the first arc's angle, the straight's length, the last arc's angle; to the left is +1.
struct Way {
  int first = 1;
  int last = 1;
  float first_angle = 0;  // [rad] 0 or more
  float straight = 0;     // [m]
  float last_angle = 0;
};

float positiveAngle(float angle) {
  const float turned = std::fmod(angle, _2_PI_);
  return turned < 0 ? turned + _2_PI_ : turned;
}

// Where an arc leads from the origin.
Pose2D arc(int side, float angle, float radius) {
  const float turn = static_cast<float>(side) * angle;
  return Pose2D(radius * std::sin(angle), static_cast<float>(side) * radius * (1 - std::cos(angle)),
                turn);
}

// The straight touches both circles, whose centres are to the sides of start and target.
std::optional<Way> findWay(const Pose2D& target, float radius, int first, int last) {
  const float along = target.x - static_cast<float>(last) * radius * std::sin(target.theta);
  const float across = target.y + static_cast<float>(last) * radius * std::cos(target.theta) -
                       static_cast<float>(first) * radius;
  const float between = std::sqrt(along * along + across * across);
  const float bearing = std::atan2(across, along);
  Way way{first, last, 0, between, 0};
  float heading = bearing;
  if (first != last) {
    if (between < 2 * radius) return std::nullopt;
    way.straight = std::sqrt(between * between - 4 * radius * radius);
    heading += static_cast<float>(first) * std::atan2(2 * radius, way.straight);
  }
  way.first_angle = positiveAngle(static_cast<float>(first) * heading);
  way.last_angle = positiveAngle(static_cast<float>(last) * (target.theta - heading));
  return way;
}

}  // namespace

std::vector<Pose2D> getDubinsSolutions(const Pose2D& target, float circle_radius) {
  if (!(circle_radius > 0)) throw std::runtime_error("ALMath: expected a radius above 0");
  std::optional<Way> best;
  const auto length = [circle_radius](const Way& way) {
    return circle_radius * (way.first_angle + way.last_angle) + way.straight;
  };
  for (const int first : {1, -1}) {
    for (const int last : {1, -1}) {
      const auto way = findWay(target, circle_radius, first, last);
      if (way && (!best || length(*way) < length(*best))) best = way;
    }
  }
  const Pose2D after_arc = arc(best->first, best->first_angle, circle_radius);
  return {after_arc, after_arc * Pose2D(best->straight, 0, 0), target};
}

}  // namespace AL::Math
