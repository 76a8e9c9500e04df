// ALMath's transforms and steady motions against numbers worked out by power series.

#include <almath/tools/almathio.h>
#include <almath/tools/altransformhelpers.h>
#include <almath/tools/avoidfootcollision.h>
#include <gtest/gtest.h>

namespace AL::Math {
namespace {

// Floats of about 1 after a dozen operations; numbers here have six digits.
constexpr float kRounding = 1e-5F;

const Transform kA = transformFromPosition(0.1F, 0.2F, 0.3F, 0.3F, -0.4F, 0.5F);
const Transform kB = transformFromPosition(-0.2F, 0.4F, 0.1F, 1.0F, 0.2F, -0.9F);

TEST(AlMathTransforms, AFramesTransformIsTakenOutside) {
  const Transform product({0.958307F, 0.15915F, -0.237318F, -0.303744F, -0.245306F, 0.032292F,
                           -0.968908F, 0.381199F, -0.146538F, 0.986726F, 0.069986F, 0.418986F});
  Transform outside;
  changeReferenceTransform(kA, kB, outside);
  EXPECT_TRUE(outside.isNear(product, kRounding)) << outside;
  Transform inside = kB;
  transformPreMultiply(kA, inside);
  EXPECT_TRUE(inside == outside);
  changeReferenceTransposeTransform(kA, outside, inside);
  EXPECT_TRUE(inside.isNear(kB, kRounding));
}

TEST(AlMathTransforms, FramesTurnDirectionsWithoutMovingThem) {
  const Position3D p(0.1F, -0.2F, 0.3F);
  Position3D turned;
  changeReferencePosition3D(kA, p, turned);
  EXPECT_TRUE(turned.isNear(Position3D(0.137191F, -0.243795F, 0.24848F), kRounding));
  changeReferenceTransposePosition3D(kA, p, turned);
  EXPECT_TRUE(turned.isNear(Position3D(0.10934F, -0.130886F, 0.333037F), kRounding));
}

TEST(AlMathTransforms, FramesTurnBothHalvesOfSixNumbers) {
  const Velocity6D v(0.1F, -0.2F, 0.3F, 0.4F, -0.5F, 0.6F);
  Velocity6D turned;
  changeReferenceVelocity6D(kA, v, turned);
  EXPECT_TRUE(turned.isNear(
      Velocity6D(0.137191F, -0.243795F, 0.24848F, 0.491944F, -0.477596F, 0.547625F), kRounding));
  changeReferenceTransposeVelocity6D(kA, turned, turned);
  EXPECT_TRUE(turned.isNear(v, kRounding));
  Position6D position;
  changeReferenceTransposePosition6D(kA, position6DFromVelocity6D(v), position);
  EXPECT_TRUE(position.isNear(
      Position6D(0.10934F, -0.130886F, 0.333037F, 0.336184F, -0.451894F, 0.672884F), kRounding));
  changeReferencePosition6D(kA, position, position);
  EXPECT_TRUE(position.isNear(position6DFromVelocity6D(v), kRounding));
}

TEST(AlMathTransforms, RotVecIsAnAxisNumberAnAngleAndAShift) {
  const Position3D p(1, 2, 3);
  EXPECT_TRUE(transformFromRotVec(2, 0.4F, p)
                  .isNear(transformFromPosition(1, 2, 3, 0, 0.4F, 0), kRounding));
  EXPECT_TRUE(transformFromRotVec(1, 0.4F).isNear(transformFromRotX(0.4F), kRounding));
  EXPECT_TRUE(transformFromRotVec(p) == Transform(1, 2, 3));
  Transform t;
  transformFromRotVecInPlace(3, 0.4F, p, t);
  EXPECT_TRUE(t.isNear(transformFromPosition(1, 2, 3, 0, 0, 0.4F), kRounding));
  EXPECT_THROW(transformFromRotVec(0, 0.4F), std::runtime_error);
}

TEST(AlMathTransforms, ARotationAndAPlaceMakeATransform) {
  const Rotation turn = rotationFrom3DRotation(0.3F, -0.4F, 0.5F);
  const Transform t = transformFromRotationPosition3D(turn, Position3D(0.1F, 0.2F, 0.3F));
  EXPECT_TRUE(t.isNear(kA, kRounding));
  EXPECT_TRUE(rotationFromTransform(t) == turn);
  EXPECT_TRUE(position2DFromTransform(t) == Position2D(0.1F, 0.2F));
  Rotation back;
  rotationFromTransformInPlace(transformFromRotation(turn), back);
  EXPECT_TRUE(back == turn);
}

TEST(AlMathTransforms, AWornTransformIsMadeOneAgain) {
  Transform worn = kA;
  worn.r2_c3 += 0.01F;
  EXPECT_FALSE(worn.isTransform());
  normalizeTransform(worn);
  EXPECT_TRUE(worn.isTransform(kRounding));
  EXPECT_TRUE(position3DFromTransform(worn) == position3DFromTransform(kA));
}

TEST(AlMathTransforms, LengthsAreOfTheShifts) {
  EXPECT_NEAR(norm(Transform(2, 3, 6)), 7, kRounding);
  EXPECT_NEAR(transformDistance(Transform(1, 1, 1), Transform(1, 4, 5)), 5, kRounding);
  EXPECT_NEAR(transformDistanceSquared(Transform(1, 1, 1), Transform(1, 4, 5)), 25, kRounding);
  EXPECT_NEAR(determinant(kA.toVector()), 1, kRounding);
}

TEST(AlMathTransforms, AnExponentialIsWhereASteadyMotionLeads) {
  const Transform led = velocityExponential(Velocity6D(0.1F, -0.2F, 0.3F, 0.4F, -0.5F, 0.6F));
  const Transform expected({0.714075F, -0.619657F, -0.325764F, 0.094117F, 0.432165F, 0.756261F,
                            -0.491226F, -0.229086F, 0.550754F, 0.209988F, 0.807821F, 0.279684F});
  EXPECT_TRUE(led.isNear(expected, kRounding)) << led;
}

TEST(AlMathTransforms, ALogarithmUndoesAnExponential) {
  for (const Velocity6D& v :
       {Velocity6D(0.1F, -0.2F, 0.3F, 0.4F, -0.5F, 0.6F), Velocity6D(1, 2, 3, 0, 0, 0),
        Velocity6D(1, 2, 3, 1e-6F, -2e-6F, 0), Velocity6D(1, 0, 0, 0, 3.14F, 0),
        Velocity6D(0.1F, 0.2F, 0.3F, -1.8F, 1.8F, 1.8F)}) {
    EXPECT_TRUE(transformLogarithm(velocityExponential(v)).isNear(v, 1e-4F))
        << v << transformLogarithm(velocityExponential(v));
  }
}

TEST(AlMathTransforms, AMeanIsAStepOnTheWay) {
  const Transform quarter = kA.diff(transformMean(kA, kB, 0.25F));
  EXPECT_TRUE((kA * quarter * quarter * quarter * quarter).isNear(kB, kRounding));
  EXPECT_TRUE(transformMean(kA, kB, 0).isNear(kA, kRounding));
  const Transform half = kA.diff(transformMean(kA, kB));
  EXPECT_TRUE((kA * half * half).isNear(kB, kRounding));
}

TEST(AlMathTransforms, ADifferenceIsAShiftAndAnAxisTimesItsAngle) {
  const Position6D diff = position6DFromTransformDiff(kA, kB);
  EXPECT_TRUE(position3DFromPosition6D(diff).isNear(Position3D(-0.3F, 0.2F, -0.2F), kRounding));
  const Position3D axis(diff.wx, diff.wy, diff.wz);
  const Rotation turn = rotationFromAngleDirection(axis.norm(), axis);
  EXPECT_TRUE((turn * rotationFromTransform(kA)).isNear(rotationFromTransform(kB), kRounding));
}

TEST(AlMathTransforms, AnInverseIsMadeInPlace) {
  Transform inverse = kA;
  transformInvertInPlace(inverse);
  EXPECT_TRUE((kA * inverse).isNear(Transform(), kRounding));
  transformInverse(kB, inverse);
  EXPECT_TRUE((inverse * kB).isNear(Transform(), kRounding));
}

TEST(AlMathTransforms, FootBoxesMayBePoints) {
  const std::vector<Position2D> sole = {Position2D(0.1F, 0.045F), Position2D(0.1F, -0.045F),
                                        Position2D(-0.06F, -0.045F), Position2D(-0.06F, 0.045F)};
  Pose2D move(0, -0.1F, 0.6F);
  EXPECT_TRUE(avoidFootCollision(sole, sole, true, move));
  EXPECT_NEAR(0.1F * std::sin(move.theta) + 0.045F * std::cos(move.theta), 0.055F, kRounding);
}

}  // namespace
}  // namespace AL::Math
