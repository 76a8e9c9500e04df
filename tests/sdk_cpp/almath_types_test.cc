// ALMath's types against numbers worked out by hand or by power series.

#include <almath/tools/almathio.h>
#include <gtest/gtest.h>

#include <sstream>
#include <type_traits>

namespace AL::Math {
namespace {

// Floats of about 1 after a dozen operations; numbers here have six digits.
constexpr float kRounding = 1e-5F;

// By 0.7 about (1, 2, -2) / 3.
const std::vector<float> kTurn = {0.790971F,  0.481736F,  0.377221F, -0.377221F, 0.869357F,
                                  -0.319254F, -0.481736F, 0.110225F, 0.869357F};
const Quaternion kTurnsQuaternion(0.939373F, 0.114299F, 0.228599F, -0.228599F);

TEST(AlMathTypes, ARotationIsMadeOfAngleAndAxisOfAnyLength) {
  EXPECT_TRUE(Rotation::fromAngleDirection(0.7F, 1, 2, -2).isNear(Rotation(kTurn), kRounding));
  EXPECT_TRUE(
      rotationFromAngleDirection(0.7F, Position3D(0.5F, 1, -1)).isNear(Rotation(kTurn), kRounding));
  EXPECT_THROW(Rotation::fromAngleDirection(0.7F, 0, 0, 0), std::runtime_error);
}

TEST(AlMathTypes, ARotationIsMadeOfAQuaternion) {
  Rotation turn;
  rotationFromQuaternion(kTurnsQuaternion, turn);
  EXPECT_TRUE(turn.isNear(Rotation(kTurn), kRounding));
  const Quaternion longer = kTurnsQuaternion * 3;
  EXPECT_TRUE(rotationFromQuaternion(longer.w, longer.x, longer.y, longer.z)
                  .isNear(Rotation(kTurn), kRounding));
}

TEST(AlMathTypes, AnglesOfThreeAxesTurnAboutXThenYThenZ) {
  const Rotation turn = rotationFrom3DRotation(0.3F, -0.4F, 0.5F);
  const Rotation expected({0.808307F, -0.559006F, -0.184803F, 0.44158F, 0.783214F, -0.437702F,
                           0.389418F, 0.272192F, 0.879923F});
  EXPECT_TRUE(turn.isNear(expected, kRounding)) << turn;
  EXPECT_TRUE(rotation3DFromRotation(turn).isNear(Rotation3D(0.3F, -0.4F, 0.5F), kRounding));
  EXPECT_TRUE((turn * Position3D(0.1F, -0.2F, 0.3F))
                  .isNear(Position3D(0.137191F, -0.243795F, 0.24848F), kRounding));
}

TEST(AlMathTypes, RotationsAboutAxesTakeEachAxisToTheNext) {
  float x = 0, y = 1, z = 0;
  applyRotation(rotationFromRotX(PI_2), x, y, z);
  EXPECT_TRUE(Position3D(x, y, z).isNear(Position3D(0, 0, 1), kRounding));
  EXPECT_TRUE(
      (rotationFromRotY(PI_2) * Position3D(0, 0, 1)).isNear(Position3D(1, 0, 0), kRounding));
  EXPECT_TRUE(
      (rotationFromRotZ(PI_2) * Position3D(1, 0, 0)).isNear(Position3D(0, 1, 0), kRounding));
}

TEST(AlMathTypes, ARotationIsMadeOfWhereItTakesTheAxes) {
  const Rotation turn(kTurn);
  const Position3D x(0.790971F, -0.377221F, -0.481736F), y(0.481736F, 0.869357F, 0.110225F),
      z(0.377221F, -0.319254F, 0.869357F);
  EXPECT_TRUE(rotationFromAxesXYZ(x, y, z) == turn);
  EXPECT_TRUE(rotationFromAxesXY(x, y).isNear(turn, kRounding));
  EXPECT_TRUE(rotationFromAxesXZ(x, z).isNear(turn, kRounding));
  EXPECT_TRUE(rotationFromAxesYZ(y, z).isNear(turn, kRounding));
  EXPECT_TRUE(isUnitVector(x));
  EXPECT_TRUE(isOrthogonal(x, y));
  EXPECT_FALSE(isUnitVector(x + y));
  EXPECT_FALSE(isOrthogonal(x, x + y));
}

TEST(AlMathTypes, HalfTurnsAreExact) {
  EXPECT_TRUE(Rotation::fromRotXPi().isNear(Rotation::fromRotX(PI), kRounding));
  EXPECT_TRUE(Rotation::fromRotYPi().isNear(Rotation::fromRotY(PI), kRounding));
  EXPECT_TRUE(Rotation::fromRotZPi().isNear(Rotation::fromRotZ(PI), kRounding));
  EXPECT_TRUE(Rotation::fromRotZHalfPi().isNear(Rotation::fromRotZ(PI_2), kRounding));
  EXPECT_TRUE(Rotation::fromRotZHalfPi() * Velocity3D(2, 0, 1) == Velocity3D(0, 2, 1));
}

TEST(AlMathTypes, APointsInertiaIsItsMassTimesSquares) {
  std::vector<float> inertia;
  pointMassRotationalInertia(2, Position3D(1, 2, 3), inertia);
  EXPECT_EQ(inertia, (std::vector<float>{26, -4, -6, -4, 20, -12, -6, -12, 10}));
}

TEST(AlMathTypes, ARotationsTransposeUndoesIt) {
  const Rotation turn(kTurn);
  EXPECT_TRUE((turn * transpose(turn)).isNear(Rotation(), kRounding));
  EXPECT_NEAR(determinant(turn), 1, kRounding);
  EXPECT_EQ(turn.toVector(), kTurn);
  EXPECT_THROW(Rotation(std::vector<float>(4)), std::runtime_error);
}

TEST(AlMathTypes, AWornRotationIsMadeOneAgain) {
  Rotation worn({1.1F, 0.1F, 0, 0, 0.9F, 0.2F, 0, 0, 2});
  EXPECT_FALSE(worn.isRotation());
  normalizeRotation(worn);
  EXPECT_TRUE(worn.isRotation(kRounding));
  EXPECT_TRUE(worn.isNear(Rotation(), kRounding));  // its x and y were in the plane z = 0
  Rotation mirror({1, 0, 0, 0, 1, 0, 0, 0, -1});
  EXPECT_FALSE(mirror.isRotation());
}

TEST(AlMathTypes, AQuaternionTurnsPointsAsItsMatrix) {
  const Position3D p(0.1F, -0.2F, 0.3F);
  EXPECT_TRUE((kTurnsQuaternion * p).isNear(Rotation(kTurn) * p, kRounding));
}

TEST(AlMathTypes, AQuaternionAndItsNegativeAreNear) {
  EXPECT_TRUE(kTurnsQuaternion.isNear(kTurnsQuaternion * -1.0F));
  EXPECT_FALSE(kTurnsQuaternion.isNear(kTurnsQuaternion.inverse()));
  EXPECT_TRUE(kTurnsQuaternion != kTurnsQuaternion * -1.0F);
}

TEST(AlMathTypes, AQuaternionTimesItsInverseIsOneAtAnyNorm) {
  const Quaternion longer = kTurnsQuaternion * 3;
  EXPECT_NEAR(norm(longer), 3, kRounding);
  EXPECT_TRUE((longer * quaternionInverse(longer)).isNear(Quaternion(), kRounding));
  EXPECT_TRUE(normalize(longer).isNear(kTurnsQuaternion, kRounding));
  EXPECT_THROW(Quaternion(0, 0, 0, 0).inverse(), std::runtime_error);
}

TEST(AlMathTypes, AQuaternionTellsItsAngleAndAxis) {
  const std::vector<float> told = angleAndAxisRotationFromQuaternion(kTurnsQuaternion);
  ASSERT_EQ(told.size(), 4U);
  EXPECT_NEAR(told[0], 0.7F, kRounding);
  EXPECT_NEAR(told[1], 1 / 3.0F, kRounding);
  EXPECT_NEAR(told[3], -2 / 3.0F, kRounding);
  EXPECT_EQ(angleAndAxisRotationFromQuaternion(Quaternion())[0], 0);
}

TEST(AlMathTypes, TurnsOfThreeAxesGoThroughAQuaternionAndBack) {
  const Rotation3D turns(0.3F, -0.4F, 0.5F);
  Quaternion q;
  quaternionFromRotation3D(turns, q);
  Rotation3D back;
  rotation3DFromQuaternion(q, back);
  EXPECT_TRUE(back.isNear(turns, kRounding));
  Position3D place;
  Quaternion same;
  quaternionPosition3DFromPosition6D(Position6D(1, 2, 3, 0.3F, -0.4F, 0.5F), same, place);
  EXPECT_TRUE(same == q);
  EXPECT_TRUE(place == Position3D(1, 2, 3));
}

TEST(AlMathTypes, ADisplacementTurnsThenShifts) {
  const Displacement quarter(Position3D(1, 0, 0),
                             Quaternion::fromAngleAndAxisRotation(PI_2, 0, 0, 1));
  const Displacement twice = quarter * quarter;
  EXPECT_TRUE(twice.isNear(Displacement(Position3D(1, 1, 0), Quaternion(0, 0, 0, 1)), kRounding));
}

TEST(AlMathTypes, APosesLengthIsItsPlacesAlone) {
  const Pose2D pose(3, 4, 10);
  EXPECT_NEAR(pose.norm(), 5, kRounding);
  EXPECT_TRUE(pose.normalize().isNear(Pose2D(0.6F, 0.8F, 2), kRounding));
  EXPECT_THROW(Pose2D(0, 0, 1).normalize(), std::runtime_error);
}

TEST(AlMathTypes, APoseSeesPointsFromOutside) {
  const Position2D seen = Pose2D(1, 2, PI_2) * Position2D(3, 0);
  EXPECT_TRUE(seen.isNear(Position2D(1, 5), kRounding));
  Pose2D pose(1, 2, 0.5F);
  changeReferencePose2DInPlace(PI_2, pose);
  EXPECT_TRUE(pose.isNear(Pose2D(-2, 1, 0.5F), kRounding));
  EXPECT_TRUE(pose2dDiff(Pose2D(1, 0, PI_2), Pose2D(1, 3, PI)).isNear(Pose2D(3, 0, PI_2), 1e-5F));
  pose2dInvertInPlace(pose);
  EXPECT_TRUE((Pose2D(-2, 1, 0.5F) * pose).isNear(Pose2D(), kRounding));
}

TEST(AlMathTypes, PositionsOfSixNumbersAreAsFarApartAsTheirPoints) {
  const Position6D a(1, 2, 3, 0.1F, 0.2F, 0.3F), b(1, 5, 7, 3, 2, 1);
  EXPECT_NEAR(distance(a, b), 5, kRounding);
  EXPECT_NEAR(distanceSquared(a, b), 25, kRounding);
  EXPECT_NEAR(norm(Position6D(1, 1, 1, 1, 2, 1)), 3, kRounding);
  EXPECT_NEAR(normalize(Position6D(1, 1, 1, 1, 2, 1)).wy, 2 / 3.0F, kRounding);
}

TEST(AlMathTypes, ANumberTimesAPositionIsAVelocity) {
  const Velocity6D velocity = 2.0F * Position6D(1, 2, 3, 4, 5, 6);
  EXPECT_TRUE(velocity == Velocity6D(2, 4, 6, 8, 10, 12));
  EXPECT_TRUE(position6DFromVelocity6D(velocity) == Position6D(1, 2, 3, 4, 5, 6) * 2);
  EXPECT_TRUE((std::is_same<decltype(2.0F * Position3D()), Velocity3D>::value));
  EXPECT_NEAR(norm(normalize(velocity)), 1, kRounding);
  EXPECT_NEAR(norm(Velocity3D(2, 3, 6)), 7, kRounding);
}

TEST(AlMathTypes, AnAngleComesBackAbovePiNotAtMinusPi) {
  EXPECT_EQ(modulo2PI(-PI), PI);
  EXPECT_EQ(modulo2PI(PI), PI);
}

TEST(AlMathTypes, AMeanAngleIsTheDirectionOfTheSum) {
  EXPECT_NEAR(meanAngle({3.0F, -2.8F}), -3.041593F, kRounding);
  EXPECT_NEAR(weightedMeanAngle({0.2F, 3.0F, -2.8F}, {1, 2, 0.5F}), 2.931673F, kRounding);
  EXPECT_THROW(meanAngle({0, PI}), std::runtime_error);
  EXPECT_THROW(weightedMeanAngle({1}, {1, 2}), std::runtime_error);
}

TEST(AlMathTypes, AMasksBitsAreTheAxes) {
  const AXIS_MASK turns(AXIS_MASK_ROT);
  EXPECT_EQ(turns.count(), 3U);
  EXPECT_FALSE(turns[2]);
  EXPECT_EQ(AXIS_MASK_VEL | AXIS_MASK_ROT, AXIS_MASK_ALL);
}

TEST(AlMathTypes, AVectorIsFilledOrReturned) {
  std::vector<float> filled = {9};
  PositionAndVelocity(0.5F, 2).toVector(filled);
  EXPECT_EQ(filled, (std::vector<float>{0.5F, 2}));
  std::vector<float> both(7, 9);
  auto to = both.begin();
  Position2D(1, 2).writeToVector(to);
  Quaternion().writeToVector(to);
  EXPECT_EQ(both, (std::vector<float>{1, 2, 1, 0, 0, 0, 9}));
  EXPECT_TRUE(PositionAndVelocity(0.5F).isNear(PositionAndVelocity(0.5F, 0)));
}

TEST(AlMathTypes, AreWrittenByNameOrAsNumbersAlone) {
  std::ostringstream text;
  text << PositionAndVelocity(0.5F, 2) << Rotation();
  EXPECT_EQ(text.str(), "PositionAndVelocity(0.5, 2)Rotation(1, 0, 0, 0, 1, 0, 0, 0, 1)");
  EXPECT_EQ(toSpaceSeparated(Position3D(1, 0.5F, -2)), "1 0.5 -2");
}

}  // namespace
}  // namespace AL::Math
