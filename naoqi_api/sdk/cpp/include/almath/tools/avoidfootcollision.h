#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <almath/types/alpose2d.h>
#include <almath/types/alposition2d.h>

namespace AL {
namespace Math {

namespace detail {

/// The least and the greatest of some corners along the normal of a side.
inline void reach(const std::vector<Pose2D>& corners, const Pose2D& side, float& low, float& high) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const float at = side.y * corners[i].x - side.x * corners[i].y;
    low = i == 0 ? at : std::min(low, at);
    high = i == 0 ? at : std::max(high, at);
  }
}

/// Whether a side of `one` has all of `other` beyond it, or the other way round.
inline bool isApart(const std::vector<Pose2D>& one, const std::vector<Pose2D>& other) {
  for (std::size_t i = 0; i < one.size(); ++i) {
    const Pose2D& next = one[(i + 1) % one.size()];
    const Pose2D side(next.x - one[i].x, next.y - one[i].y, 0);
    float low[2] = {0, 0}, high[2] = {0, 0};
    reach(one, side, low[0], high[0]);
    reach(other, side, low[1], high[1]);
    if (high[0] <= low[1] || high[1] <= low[0]) return true;
  }
  return false;
}

inline bool feetOverlap(const std::vector<Pose2D>& standing, const std::vector<Pose2D>& swinging,
                        const Pose2D& move) {
  std::vector<Pose2D> placed;
  for (std::size_t i = 0; i < swinging.size(); ++i) placed.push_back(move * swinging[i]);
  return !isApart(standing, placed) && !isApart(placed, standing);
}

}  // namespace detail

/// Draws a step's x and y in along their own direction, onto the ellipse of these half axes [m];
/// true if it lay outside.
inline bool clipFootWithEllipse(const float& max_x, const float& max_y, Pose2D& move) {
  const float share =
      std::sqrt(move.x * move.x / (max_x * max_x) + move.y * move.y / (max_y * max_y));
  if (!(share > 1)) return false;
  move.x /= share;
  move.y /= share;
  return true;
}

/// Turns the swinging foot back until it does not overlap the standing one; true if it did.
/// Nothing but theta changes. A box is a foot's corners, in order around it and in its own frame;
/// `move` is the swinging foot as the standing one sees it.
inline bool avoidFootCollision(const std::vector<Pose2D>& left_box,
                               const std::vector<Pose2D>& right_box, const bool& is_left_support,
                               Pose2D& move) {
  const std::vector<Pose2D>& standing = is_left_support ? left_box : right_box;
  const std::vector<Pose2D>& swinging = is_left_support ? right_box : left_box;
  if (!detail::feetOverlap(standing, swinging, move)) return false;
  float meeting = move.theta, free = 0;
  move.theta = 0;
  if (detail::feetOverlap(standing, swinging, move)) return true;
  for (int halvings = 0; halvings < 20; ++halvings) {
    move.theta = (free + meeting) / 2;
    (detail::feetOverlap(standing, swinging, move) ? meeting : free) = move.theta;
  }
  move.theta = free;
  return true;
}

/// The same with boxes of points.
inline bool avoidFootCollision(const std::vector<Position2D>& left_box,
                               const std::vector<Position2D>& right_box,
                               const bool& is_left_support, Pose2D& move) {
  std::vector<Pose2D> boxes[2];
  for (std::size_t i = 0; i < left_box.size(); ++i)
    boxes[0].push_back(Pose2D(left_box[i].x, left_box[i].y, 0));
  for (std::size_t i = 0; i < right_box.size(); ++i)
    boxes[1].push_back(Pose2D(right_box[i].x, right_box[i].y, 0));
  return avoidFootCollision(boxes[0], boxes[1], is_left_support, move);
}

}  // namespace Math
}  // namespace AL
