#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "walk_engine/footstep_plan.h"
#include "walk_engine/zmp_qp.h"

namespace nao::walk {

/// The area that carries the robot at an instant of its plan: the sole of one foot, or all that
/// lies between both. Landings that may still be moved take their part of it along.
class Support {
 public:
  /// The soles of `model`, drawn in by `margin` [m].
  Support(const RobotModel& model, double margin);

  /// The feet at one instant. `landing`: the number of the landing that placed a foot, counted from
  /// the one under way; -1 for feet that stand.
  struct Feet {
    FeetPlaces places;
    std::array<bool, 2> stands{true, true};
    std::array<int, 2> landing{-1, -1};
  };
  /// The feet of `plan` at `tick`.
  static Feet feetAt(const FootstepPlan& plan, std::int64_t tick);

  /// The edges of the area, counter-clockwise. Landings from `movable` on move with the last
  /// before.
  std::vector<SupportEdge> edges(const Feet& feet, int movable) const;

 private:
  std::array<std::vector<Eigen::Vector2d>, 2> outline_;  // [m] in the sole's frame, by Foot
};

}  // namespace nao::walk
