#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include <usarnaoqi_sdk/test_world.h>

namespace usarnaoqi {

/// EXPECT_TRUE(stands(world)): the first robot has not fallen.
inline testing::AssertionResult stands(const TestWorld& world) {
  const double tilt = world.tilt() * 180 / M_PI;
  if (tilt < 60) return testing::AssertionSuccess() << "it stands";
  return testing::AssertionFailure()
         << "it has fallen at " << world.time() << " s: its torso tilts by " << tilt << " degrees";
}

/// EXPECT_TRUE(isAt(world, 0.3, 0, 0.1)): the first robot is so many metres from there at most.
inline testing::AssertionResult isAt(const TestWorld& world, double x, double y, double within) {
  const std::vector<float> pose = world.floorPose();
  const double away = std::hypot(pose.at(0) - x, pose.at(1) - y);
  if (away <= within) return testing::AssertionSuccess() << "it is there";
  return testing::AssertionFailure() << "it is at (" << pose[0] << ", " << pose[1] << ") at "
                                     << world.time() << " s, " << away << " m away";
}

}  // namespace usarnaoqi
