#include "motion/timeline/route.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "motion/trajectory.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

std::shared_ptr<RobotModel> robotWithWays() {
  auto robot = makeTestRobot();
  const Joint yaw = *robot->findJoint("HeadYaw");
  const Joint pitch = *robot->findJoint("HeadPitch");
  robot->postures.push_back({"Up", "Over", JointArray<double>(robot->jointCount(), 0.1)});
  Way up{"Up", {"Under"}, "Between", {}};
  up.keys.push_back({1.0, {{yaw, 0.5}, {pitch, -0.2}}, -4, 4, 0});
  up.keys.push_back({0.5, {{pitch, 0.2}}, -4, 4, 0});
  up.keys.push_back({0.5, {{yaw, -0.5}}, -4, 4, 0});
  Way on{"On", {"Between"}, "Over", {}};
  on.keys.push_back({2.0, {{yaw, 1.0}}, -4, 4, 0});
  robot->ways = {up, on};
  return robot;
}

std::string errorOf(const std::string& text) {
  try {
    readMotion(text, "up.route", *robotWithWays());
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Route, LaysTheKeysOfItsWaysOneAfterTheOther) {
  const auto robot = robotWithWays();
  const Timeline timeline =
      readMotion("# up\nfrom Under\nto Up # there\nrest 0.5\nwithin 1.5\n", "up.route", *robot);
  EXPECT_NEAR(timeline.length, 2.0 + 0.5 + 2.0 + 0.5 + 1.5, 1e-9);
  const auto angleAt = [&](const char* name, double time) {
    for (const Curve& curve : timeline.curves) {
      if (curve.joint == *robot->findJoint(name)) return Trajectory(0, curve.keys).at(time);
    }
    return -99.0;
  };
  for (const auto& [time, yaw, pitch] :
       {std::tuple{1.0, 0.5, -0.2}, std::tuple{1.25, 0.5, 0.0}, std::tuple{1.5, 0.5, 0.2},
        std::tuple{1.75, 0.0, 0.2}, std::tuple{2.0, -0.5, 0.2}, std::tuple{2.5, -0.5, 0.2},
        std::tuple{3.5, 0.25, 0.2}, std::tuple{4.5, 1.0, 0.2}, std::tuple{6.5, 0.1, 0.1}}) {
    EXPECT_NEAR(angleAt("HeadYaw", time), yaw, 1e-6) << time;
    EXPECT_NEAR(angleAt("HeadPitch", time), pitch, 1e-6) << time;
  }
  // Each leg of it begins and ends at rest: a quarter of the time covers 5/32 of the way.
  EXPECT_NEAR(angleAt("HeadYaw", 3.0), -0.5 + 1.5 * 5 / 32, 1e-6);
}

TEST(Route, WhatIsWrongIsToldWithItsLine) {
  EXPECT_EQ(errorOf("from Under\n"), "up.route:1: expected a line from and a line to");
  EXPECT_EQ(errorOf("from Under\nto Up\nslowly\n"),
            "up.route:3: expected from, to, rest or within, and one value");
  EXPECT_EQ(errorOf("from Under\nto Sky\n"), "up.route:2: robot test_nao has no posture Sky");
  EXPECT_EQ(errorOf("from Nowhere\nto Up\n"),
            "up.route:2: robot test_nao has no way from Nowhere to Over, where Up is");
  EXPECT_EQ(errorOf("from Under\nto Up\nrest 0\n"), "up.route:3: the time must be positive");
}

}  // namespace
}  // namespace nao::motion
