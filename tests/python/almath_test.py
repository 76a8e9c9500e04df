"""almath: laws that its rotations, transforms and poses obey, and the numbers of hand."""

import math
import unittest

import support  # noqa: F401  # finds the package
import almath

EXACT = 1e-12  # some roundings of numbers about 1
ROUND_TRIP = 1e-9  # roundings of an arc function near its steep ends
SOME = almath.Transform.fromPosition(0.1, -0.2, 0.3, 0.4, -0.5, 2.6)
OTHER = almath.Transform.fromPosition(-1.0, 2.0, 0.5, -1.1, 0.7, -0.3)


class TransformTest(unittest.TestCase):
    def assertNear(self, a, b, tolerance=EXACT):
        self.assertTrue(a.isNear(b, tolerance), "%r is not %r" % (a, b))

    def testIsMadeOfAllItsForms(self):
        self.assertEqual(almath.Transform().toVector()[:6], [1, 0, 0, 0, 0, 1])
        self.assertEqual(almath.Transform(1, 2, 3).position(), almath.Position3D(1, 2, 3))
        for numbers in (SOME.toVector(), SOME.toVector()[:12], SOME):
            self.assertEqual(almath.Transform(numbers), SOME)
        with self.assertRaises(RuntimeError):
            almath.Transform([1, 2, 3, 4])

    def testAVectorOfItHasSixteenNumbers(self):
        self.assertEqual(len(SOME.toVector()), 16)
        self.assertEqual(list(SOME)[12:], [0, 0, 0, 1])

    def testItsInverseUndoesIt(self):
        self.assertNear(SOME * SOME.inverse(), almath.Transform())
        self.assertNear(SOME * SOME.diff(OTHER), OTHER)
        self.assertNear(almath.transformInverse(SOME * OTHER), OTHER.inverse() * SOME.inverse())

    def testMultipliesPointsAsItself(self):
        point = almath.Position3D(0.3, 0.2, -0.1)
        self.assertNear((SOME * OTHER) * point, SOME * (OTHER * point))

    def testAReferenceIsChangedAndChangedBack(self):
        seen = almath.Transform()
        almath.changeReferenceTransform(SOME, OTHER, seen)
        self.assertEqual(seen, SOME * OTHER)
        self.assertNear(almath.changeReferenceTransposeTransform(SOME, seen), OTHER)
        for kind, name in ((almath.Position3D, "Position3D"), (almath.Position6D, "Position6D"),
                           (almath.Velocity6D, "Velocity6D")):
            six = kind(*[0.1, -0.2, 0.3, 0.4, -0.5, 0.6][:len(kind())])
            there = getattr(almath, "changeReference" + name)(SOME, six)
            self.assertNear(getattr(almath, "changeReferenceTranspose" + name)(SOME, there), six)
        # A quarter turn about z: x becomes y, whatever the frame's place.
        quarter = almath.Transform.fromPosition(5, 6, 7, 0, 0, math.pi / 2)
        self.assertNear(almath.changeReferencePosition3D(quarter, almath.Position3D(1, 0, 0)),
                        almath.Position3D(0, 1, 0))

    def testATurnAboutANumberedAxis(self):
        self.assertNear(almath.transformFromRotVec(2, 0.3), almath.transformFromRotY(0.3))
        place = almath.Position3D(1, 2, 3)
        self.assertNear(almath.transformFromRotVec(3, 0.3, place),
                        almath.Transform(1, 2, 3) * almath.transformFromRotZ(0.3))
        self.assertEqual(almath.transformFromRotVec(place), almath.Transform(1, 2, 3))
        with self.assertRaises(RuntimeError):
            almath.transformFromRotVec(4, 0.3)

    def testWhatLeadsFromOneToAnotherSeenFromOutside(self):
        step = almath.position6DFromTransformDiff(SOME, OTHER)
        turn = almath.velocityExponential(almath.Velocity6D(0, 0, 0, step.wx, step.wy, step.wz))
        self.assertNear(turn.rotation() * SOME.rotation(), OTHER.rotation(), ROUND_TRIP)
        self.assertNear(SOME.position() + almath.position3DFromPosition6D(step), OTHER.position())
        self.assertNear(almath.transformFromPosition6D(
            almath.transformDifferenceInPosition6D(SOME, OTHER)), SOME.diff(OTHER), ROUND_TRIP)

    def testDisplacementsAreTransforms(self):
        def of(transform):
            return almath.Displacement(transform.position(),
                                       almath.quaternionFromTransform(transform))
        self.assertTrue((of(SOME) * of(OTHER)).isNear(of(SOME * OTHER), ROUND_TRIP))
        self.assertFalse(of(SOME).isNear(of(OTHER)))

    def testFunctionsInPlaceDoAsThoseThatReturn(self):
        pose, transform = almath.Pose2D(), almath.Transform(SOME)
        almath.pose2DFromTransformInPlace(SOME, pose)
        self.assertEqual(pose, almath.pose2DFromTransform(SOME))
        almath.transformInvertInPlace(transform)
        self.assertEqual(transform, SOME.inverse())
        almath.transformMeanInPlace(SOME, OTHER, 0.25, transform)
        self.assertEqual(transform, almath.transformMean(SOME, OTHER, 0.25))

    def testDistancesOfPlacesWithTurnsAreThoseOfThePlaces(self):
        self.assertAlmostEqual(almath.distance(almath.Position6D(0, 0, 0, 1, 2, 3),
                                               almath.Position6D(2, 3, 6, 0, 0, 0)), 7)

    def testAPointsInertiaIsThatAboutTheOrigin(self):
        inertia = []
        almath.pointMassRotationalInertia(2, almath.Position3D(3, 0, 4), inertia)
        self.assertEqual(inertia, [32, 0, -24, 0, 50, 0, -24, 0, 18])

    def testATransformAndItsVelocityGoTogether(self):
        moving = almath.TransformAndVelocity6D(SOME, almath.Velocity6D(1, 2, 3, 4, 5, 6))
        self.assertEqual((moving.T, moving.V.wzd), (SOME, 6))
        self.assertTrue(moving.isNear(almath.TransformAndVelocity6D(moving.T, moving.V)))
        self.assertFalse(moving.isNear(almath.TransformAndVelocity6D()))
        moving.T *= SOME.inverse()
        self.assertNotEqual(moving.T, SOME)

    def testDeterminantsAreThoseOfTheTurn(self):
        self.assertAlmostEqual(almath.determinant(SOME), 1.0, delta=EXACT)
        numbers = [2, 1, 0, 9, 0, 3, 1, 9, 4, 0, 5, 9]  # 2 * 15 - 1 * (0 - 4)
        for matrix in (numbers, almath.Transform(numbers),
                       almath.Rotation(2, 1, 0, 0, 3, 1, 4, 0, 5)):
            self.assertAlmostEqual(almath.determinant(matrix), 34.0)

    def testInPlaceProductsAreProducts(self):
        target = almath.Transform(SOME)
        target *= OTHER
        self.assertEqual(target, SOME * OTHER)
        self.assertNotEqual(target, SOME)

    def testPosition6DIsAboutXThenYThenZOfTheFixedFrame(self):
        self.assertNear(almath.transformFromPosition6D(almath.position6DFromTransform(SOME)), SOME,
                        ROUND_TRIP)
        turned = almath.Transform.from3DRotation(math.pi / 2, 0, math.pi / 2)
        self.assertNear(turned * almath.Position3D(0, 1, 0), almath.Position3D(0, 0, 1))
        self.assertNear(turned * almath.Position3D(1, 0, 0), almath.Position3D(0, 1, 0))

    def testExponentialAndLogarithmUndoEachOther(self):
        for transform in (SOME, OTHER, almath.Transform(1, 2, 3), almath.Transform()):
            velocity = almath.transformLogarithm(transform)
            self.assertNear(almath.velocityExponential(velocity), transform, ROUND_TRIP)

    def testTheMeanIsAsFarFromBoth(self):
        mean = almath.transformMean(SOME, OTHER)
        self.assertNear(SOME.diff(mean), mean.diff(OTHER), ROUND_TRIP)

    def testNormalizingMakesARotationAgain(self):
        bent = almath.Transform([value * 1.01 for value in SOME.toVector()[:12]])
        self.assertFalse(bent.isTransform())
        self.assertTrue(bent.normalizeTransform().isTransform(EXACT))


class RotationTest(unittest.TestCase):
    def testQuaternionsTurnAsMatrices(self):
        for angles in ((0.1, 0.2, 0.3), (3.0, 0.1, -2.0), (0, 0, math.pi), (math.pi, 0, 0)):
            rotation = almath.rotationFrom3DRotation(*angles)
            again = almath.rotationFromQuaternion(almath.quaternionFromRotation(rotation))
            self.assertTrue(rotation.isNear(again, ROUND_TRIP), angles)
            self.assertAlmostEqual(rotation.determinant(), 1.0, delta=EXACT)

    def testProductsOfQuaternionsAreProductsOfRotations(self):
        a, b = (almath.quaternionFromRotation3D(almath.Rotation3D(*angles))
                for angles in ((0.3, -0.2, 0.9), (1.0, 0.4, -2.0)))
        product = almath.rotationFromQuaternion(a) * almath.rotationFromQuaternion(b)
        self.assertTrue(almath.rotationFromQuaternion(a * b).isNear(product, EXACT))

    def testHalfAndQuarterTurnsAreExact(self):
        self.assertEqual(almath.Rotation.fromRotXPi() * almath.Position3D(1, 2, 3),
                         almath.Position3D(1, -2, -3))
        self.assertEqual(almath.Rotation.fromRotYPi() * almath.Position3D(1, 2, 3),
                         almath.Position3D(-1, 2, -3))
        self.assertEqual(almath.Rotation.fromRotZPi() * almath.Position3D(1, 2, 3),
                         almath.Position3D(-1, -2, 3))
        self.assertEqual(almath.Rotation.fromRotZHalfPi() * almath.Position3D(1, 2, 3),
                         almath.Position3D(-2, 1, 3))

    def testTurnsKeepWhatAVectorIs(self):
        quarter = almath.quaternionFromAngleAndAxisRotation(math.pi / 2, 0, 0, 1)
        turned = quarter * almath.Position3D(1, 2, 3)
        self.assertTrue(turned.isNear(almath.Position3D(-2, 1, 3), EXACT), turned)
        turned = almath.rotationFromQuaternion(quarter) * almath.Velocity3D(1, 2, 3)
        self.assertIsInstance(turned, almath.Velocity3D)
        self.assertTrue(turned.isNear(almath.Velocity3D(-2, 1, 3), EXACT), turned)

    def testAQuaternionAndItsNegativeTurnAlike(self):
        some = almath.quaternionFromAngleAndAxisRotation(0.7, 0.6, 0.0, 0.8)
        self.assertTrue(some.isNear(-some))
        self.assertFalse(some.isNear(some.inverse()))

    def testAngleAndAxisComeBack(self):
        quaternion = almath.quaternionFromAngleAndAxisRotation(0.7, 0.6, 0.0, 0.8)
        for value, expected in zip(almath.angleAndAxisRotationFromQuaternion(quaternion),
                                   (0.7, 0.6, 0.0, 0.8)):
            self.assertAlmostEqual(value, expected, delta=ROUND_TRIP)

    def testAxesMakeRightHandedFrames(self):
        x, z = almath.Position3D(0, 1, 0), almath.Position3D(0, 0, 1)
        rotation = almath.rotationFromAxesXZ(x, z)
        self.assertTrue(rotation.isNear(almath.rotationFromRotZ(math.pi / 2), EXACT))


class PoseTest(unittest.TestCase):
    def testTheMoveBetweenTwoPosesIsInTheFirstOnesFrame(self):
        start = almath.Pose2D([1.0, 2.0, math.pi / 2])
        end = almath.Pose2D(1.0, 2.3, math.pi / 2 + 0.1)
        move = almath.pose2DInverse(start) * end
        self.assertTrue(move.isNear(almath.Pose2D(0.3, 0.0, 0.1), EXACT), move)
        self.assertTrue((start * move).isNear(end, EXACT))

    def testIsATransformOfThePlane(self):
        a, b = almath.Pose2D(0.1, 0.2, 0.3), almath.Pose2D(-1, 2, 1.5)
        product = almath.transformFromPose2D(a) * almath.transformFromPose2D(b)
        self.assertTrue(almath.pose2DFromTransform(product).isNear(a * b, ROUND_TRIP))


class DubinsTest(unittest.TestCase):
    RADIUS = 0.3  # m

    def targets(self):
        for x in (-1.0, -0.2, 0.1, 0.9):
            for y in (-0.7, 0.0, 0.4):
                for theta in (-2.5, -0.5, 0.0, 1.0, 3.0):
                    yield almath.Pose2D(x, y, theta)

    def testItsPartsLeadToTheTarget(self):
        for target in self.targets():
            end = almath.getDubinsSolutions(target, self.RADIUS)[-1]
            self.assertLess(end.distance(target), ROUND_TRIP, target)
            self.assertLess(abs(almath.modulo2PI(end.theta - target.theta)), ROUND_TRIP, target)

    def testTurnsOnItsRadiusOrNotAtAll(self):
        for target in self.targets():
            before = almath.Pose2D()
            for pose in almath.getDubinsSolutions(target, self.RADIUS):
                turned = abs(pose.theta - before.theta)
                if turned > ROUND_TRIP:
                    chord = 2 * self.RADIUS * abs(math.sin(turned / 2))
                    self.assertAlmostEqual(before.distance(pose), chord, delta=ROUND_TRIP)
                before = pose

    def testStraightAheadIsStraight(self):
        poses = almath.getDubinsSolutions(almath.Pose2D(1, 0, 0), self.RADIUS)
        self.assertEqual([pose.y for pose in poses], [0, 0, 0])

    def length(self, target):
        """Of the way: arcs turn, the straight line does not."""
        before, total = almath.Pose2D(), 0.0
        for pose in almath.getDubinsSolutions(target, self.RADIUS):
            turned = abs(pose.theta - before.theta)
            total += turned * self.RADIUS if turned else before.distance(pose)
            before = pose
        return total

    def testAMirroredTargetIsAsFar(self):
        for target in self.targets():
            mirrored = almath.Pose2D(target.x, -target.y, -target.theta)
            self.assertAlmostEqual(self.length(target), self.length(mirrored), delta=ROUND_TRIP)

    def testTheWayBackIsAsLongAsTheWayThere(self):
        for target in self.targets():  # driven backwards, a way ends where it began
            back = almath.Pose2D(target.x, target.y, target.theta).inverse()
            turned = almath.Pose2D(-back.x, -back.y, back.theta)  # both poses turned round
            self.assertAlmostEqual(self.length(target), self.length(turned), delta=ROUND_TRIP)

    def testNeedsARadius(self):
        with self.assertRaises(RuntimeError):
            almath.getDubinsSolutions(almath.Pose2D(1, 0, 0), 0.0)


class ToolsTest(unittest.TestCase):
    def testModuloKeepsTheDirection(self):
        for angle in (0.0, 1.0, -1.0, 4.0, -4.0, 100.0, -100.0, math.pi):
            inside = almath.modulo2PI(angle)
            self.assertTrue(-math.pi < inside <= math.pi)
            self.assertAlmostEqual(math.cos(inside), math.cos(angle), delta=ROUND_TRIP)
            self.assertAlmostEqual(math.sin(inside), math.sin(angle), delta=ROUND_TRIP)
        self.assertEqual(almath.modulo2PI(-math.pi), math.pi)

    def testAMeanAngleLiesBetweenAcrossTheTurn(self):
        self.assertAlmostEqual(abs(almath.meanAngle([3.1, -3.1])), math.pi, delta=ROUND_TRIP)
        with self.assertRaises(RuntimeError):
            almath.meanAngle([0.0, math.pi])

    def testUnitVectorsAndRightAnglesAreTold(self):
        self.assertTrue(almath.isUnitVector(almath.Position3D(0.6, 0, -0.8)))
        self.assertFalse(almath.isUnitVector(almath.Position3D(0.6, 0, -0.81)))
        self.assertTrue(almath.isUnitVector(almath.Position3D(0.6, 0, -0.81), 0.1))
        self.assertTrue(almath.isOrthogonal(almath.Position3D(1, 2, 3),
                                            almath.Position3D(3, 0, -1)))
        self.assertFalse(almath.isOrthogonal(almath.Position3D(1, 2, 3),
                                             almath.Position3D(3, 0, -1.1)))

    def testVectorsAddScaleAndCross(self):
        a, b = almath.Position3D(1, 2, 3), almath.Position3D(-1, 0, 2)
        self.assertEqual(a + b * 2, almath.Position3D(-1, 2, 7))
        self.assertEqual(2 * a - a / 2, almath.Position3D(1.5, 3, 4.5))
        cross = a.crossProduct(b)
        self.assertEqual((cross.dotProduct(a), cross.dotProduct(b)), (0, 0))
        with self.assertRaises(RuntimeError):
            almath.Position3D().normalize()
        with self.assertRaises(RuntimeError):
            almath.Position2D(1, 2) + a


class FootstepsTest(unittest.TestCase):
    # A sole of 16 by 9 cm about its ankle.
    SOLE = [almath.Pose2D(x, y, 0) for x, y in
            ((0.1, 0.045), (0.1, -0.045), (-0.06, -0.045), (-0.06, 0.045))]

    def testAStepOutsideTheEllipseIsDrawnOntoIt(self):
        move = almath.Pose2D(0.08, -0.08, 0.3)
        self.assertTrue(almath.clipFootWithEllipse(0.08, 0.04, move))
        self.assertAlmostEqual((move.x / 0.08) ** 2 + (move.y / 0.04) ** 2, 1, delta=EXACT)
        self.assertAlmostEqual(move.x, -move.y, delta=EXACT)  # the same direction
        self.assertEqual(move.theta, 0.3)

    def testAStepInsideTheEllipseIsLeftAlone(self):
        move = almath.Pose2D(0.05, 0.02, 1)
        self.assertFalse(almath.clipFootWithEllipse(0.08, 0.04, move))
        self.assertEqual(move, almath.Pose2D(0.05, 0.02, 1))

    def testAFootThatWouldStepOnTheOtherIsTurnedBackUntilTheyTouch(self):
        move = almath.Pose2D(0.0, -0.1, 0.6)  # the right foot beside the left one, turned in
        self.assertTrue(almath.avoidFootCollision(self.SOLE, self.SOLE, True, move))
        self.assertEqual((move.x, move.y), (0.0, -0.1))
        # The inner front corner meets y = -0.045: 0.1 sin t + 0.045 cos t = 0.055.
        self.assertAlmostEqual(0.1 * math.sin(move.theta) + 0.045 * math.cos(move.theta), 0.055,
                               delta=1e-6)
        self.assertFalse(almath.avoidFootCollision(self.SOLE, self.SOLE, True, move))

    def testFeetApartTurnAsTheyLike(self):
        for left_stands, y in ((True, -0.2), (False, 0.2)):
            move = almath.Pose2D(0.05, y, 1.0)
            self.assertFalse(almath.avoidFootCollision(self.SOLE, self.SOLE, left_stands, move))
            self.assertEqual(move.theta, 1.0)

    def testFeetThatMeetHoweverTheyTurnAreStraight(self):
        move = almath.Pose2D(0.0, -0.05, 0.5)
        self.assertTrue(almath.avoidFootCollision(self.SOLE, self.SOLE, True, move))
        self.assertEqual(move.theta, 0)


if __name__ == "__main__":
    unittest.main()
