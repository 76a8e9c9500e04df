#include <almath/tools/aldubinscurve.h>
#include <almath/tools/almathio.h>
#include <almath/tools/altransformhelpers.h>
#include <almath/tools/avoidfootcollision.h>
#include <gtest/gtest.h>

namespace AL::Math {
namespace {

// Floats of about 1 after a dozen operations.
constexpr float kRounding = 1e-5F;

TEST(AlMath, APoseTimesItsInverseIsNoMove) {
  const Pose2D pose(1.0F, -2.0F, 2.5F);
  EXPECT_TRUE((pose * pose.inverse()).isNear(Pose2D(), kRounding));
  EXPECT_TRUE((pose2DInverse(pose) * pose).isNear(Pose2D(), kRounding));
}

TEST(AlMath, ATransformIsItsPositionAndTurnsBackAndForth) {
  const Position6D position(0.1F, -0.2F, 0.3F, 1.2F, -0.7F, 2.9F);
  const Transform transform = transformFromPosition6D(position);
  EXPECT_TRUE(position6DFromTransform(transform).isNear(position, kRounding));
  EXPECT_NEAR(transform.determinant(), 1.0F, kRounding);
  EXPECT_TRUE((transform * transform.inverse()).isNear(Transform(), kRounding));
}

TEST(AlMath, AQuarterTurnAboutZTakesXToY) {
  const Position3D turned = Transform::fromRotZ(90.0F * TO_RAD) * Position3D(1, 0, 0);
  EXPECT_TRUE(turned.isNear(Position3D(0, 1, 0), kRounding));
}

TEST(AlMath, AQuaternionTurnsAsItsTransform) {
  const Transform turn = transformFrom3DRotation(0.4F, 0.5F, -2.6F);
  EXPECT_TRUE(transformFromQuaternion(quaternionFromTransform(turn)).isNear(turn, kRounding));
}

TEST(AlMath, AVectorIsSixteenNumbersRowByRow) {
  const std::vector<float> numbers = Transform(1, 2, 3).toVector();
  EXPECT_EQ(numbers, (std::vector<float>{1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3, 0, 0, 0, 1}));
  EXPECT_TRUE(Transform(numbers) == Transform(1, 2, 3));
  EXPECT_THROW(Transform(std::vector<float>(5)), std::runtime_error);
}

TEST(AlMath, AnglesComeBackWithinATurn) {
  EXPECT_NEAR(modulo2PI(3 * PI + 0.5F), -PI + 0.5F, kRounding);
  EXPECT_NEAR(modulo2PI(-0.5F), -0.5F, kRounding);
}

// Each part is an arc of the radius or a straight: from pose to pose the chord and the change of
// heading fit together.
TEST(AlMath, DubinsWaysAreArcStraightArcToTheTarget) {
  const float radius = 0.1F;
  for (const Pose2D& target :
       {Pose2D(0, -0.4F, 0), Pose2D(1, 1, 2), Pose2D(-1, 0.3F, -2), Pose2D(0.05F, 0, 3)}) {
    const std::vector<Pose2D> ends = getDubinsSolutions(target, radius);
    ASSERT_EQ(ends.size(), 3U);
    EXPECT_TRUE(ends.back() == target);
    const Pose2D straight = ends[0].diff(ends[1]);
    EXPECT_NEAR(straight.y, 0, kRounding);
    EXPECT_NEAR(straight.theta, 0, kRounding);
    for (const Pose2D& part : {ends[0], ends[1].diff(ends[2])}) {
      const float chord = 2 * radius * std::fabs(std::sin(part.theta / 2));
      EXPECT_NEAR(std::sqrt(part.x * part.x + part.y * part.y), chord, kRounding) << target;
    }
  }
}

TEST(AlMath, AStepIsDrawnOntoTheEllipse) {
  Pose2D move(0.08F, -0.08F, 0.3F);
  EXPECT_TRUE(clipFootWithEllipse(0.08F, 0.04F, move));
  EXPECT_NEAR(std::hypot(move.x / 0.08F, move.y / 0.04F), 1, kRounding);
  EXPECT_NEAR(move.x, -move.y, kRounding);
  EXPECT_FALSE(clipFootWithEllipse(0.09F, 0.05F, move));
}

TEST(AlMath, AFootIsTurnedBackUntilItTouchesTheOther) {
  const std::vector<Pose2D> sole = {Pose2D(0.1F, 0.045F, 0), Pose2D(0.1F, -0.045F, 0),
                                    Pose2D(-0.06F, -0.045F, 0), Pose2D(-0.06F, 0.045F, 0)};
  Pose2D move(0, -0.1F, 0.6F);
  EXPECT_TRUE(avoidFootCollision(sole, sole, true, move));
  // The inner front corner meets y = -0.045.
  EXPECT_NEAR(0.1F * std::sin(move.theta) + 0.045F * std::cos(move.theta), 0.055F, kRounding);
  EXPECT_EQ(move.y, -0.1F);
  Pose2D apart(0.05F, 0.2F, 1);
  EXPECT_FALSE(avoidFootCollision(sole, sole, false, apart));
}

}  // namespace
}  // namespace AL::Math
