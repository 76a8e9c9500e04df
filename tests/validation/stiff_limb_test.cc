#include "validation/stiff_limb.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

// Two rods of 1 kg and 1 m, the second hinged about z at the end of the first.
RobotModel twoRods() {
  RobotModel model;
  model.bodies.resize(3);
  for (int b : {1, 2}) {
    Body& rod = model.bodies[static_cast<std::size_t>(b)];
    rod.parent = b - 1;
    rod.mass = 1;
    rod.p_BoBcm = {0.5, 0, 0};
    rod.I_Bcm = Vec3(0, 1 / 12.0, 1 / 12.0).asDiagonal();
  }
  model.bodies[2].X_PB.translation().x() = 1;
  model.coordinates.resize(2);
  model.coordinates[1].joint = toJoint(1);
  return model;
}

TEST(StiffLimb, StretchedIsOneLongRod) {
  const Body solid = stiffened(twoRods(), 1, JointArray<double>(2));
  EXPECT_DOUBLE_EQ(solid.mass, 2);
  EXPECT_TRUE(solid.p_BoBcm.isApprox(Vec3(1, 0, 0), 1e-12));
  EXPECT_TRUE(solid.I_Bcm.isApprox(Mat3(Vec3(0, 8 / 12.0, 8 / 12.0).asDiagonal()), 1e-12));
}

// Both centres are 0.5 sqrt(0.5) m from the one of the square they span.
TEST(StiffLimb, BentIsASquare) {
  JointArray<double> pose(2);
  pose[toJoint(1)] = M_PI / 2;
  const Body solid = stiffened(twoRods(), 1, pose);
  EXPECT_TRUE(solid.p_BoBcm.isApprox(Vec3(0.75, 0.25, 0), 1e-12));
  EXPECT_NEAR(solid.I_Bcm(2, 2), 2 / 12.0 + 2 * 0.125, 1e-12);
  EXPECT_NEAR(solid.I_Bcm(0, 0), 1 / 12.0 + 2 * 0.0625, 1e-12);
}

TEST(StiffLimb, OfTheLastBodyNothingChanges) {
  const RobotModel model = twoRods();
  const Body solid = stiffened(model, 2, JointArray<double>(2));
  EXPECT_TRUE(solid.p_BoBcm.isApprox(model.bodies[2].p_BoBcm, 1e-12));
  EXPECT_TRUE(solid.I_Bcm.isApprox(model.bodies[2].I_Bcm, 1e-12));
}

}  // namespace
}  // namespace nao::validation
