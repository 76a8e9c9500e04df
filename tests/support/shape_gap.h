#pragma once

#include "core/robot_model.h"

namespace nao::test {

/// The gap [m] between two solids given in W, to 0.1 mm: above zero when apart. Overlapping solids
/// give zero or, if they are round, less; how deep is not asked. Slow, but by a way of its own:
/// what the simulation computes can be held against it.
double shapeGap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

/// The poses of all bodies in the root's frame, the actuators at `angle`.
std::vector<Pose> bodyPoses(const RobotModel& model, const JointArray<double>& angle);

/// The smallest gap between collision solids of two bodies; 1 m if one of them has none.
double bodyGap(const RobotModel& model, const std::vector<Pose>& X_RB, int a, int b);

}  // namespace nao::test
