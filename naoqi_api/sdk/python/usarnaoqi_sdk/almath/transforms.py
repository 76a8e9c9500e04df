"""Rigid motions as matrices of 4 x 4, whose last row is 0 0 0 1."""

import math
from typing import Any, List

from .record import NEAR, Record
from .rotations import (Quaternion, Rotation, fromRows, multiply, quaternionFromRotation,
                        rotation3DFromRotation, rotationFrom3DRotation, rotationFromAngleDirection,
                        rotationFromQuaternion, rotationFromRotX, rotationFromRotY,
                        rotationFromRotZ)
from .vectors import Pose2D, Position2D, Position3D, Position6D, Rotation3D, Velocity6D

LAST_ROW = [0.0, 0.0, 0.0, 1.0]


class Transform(Record):
    """Made of nothing (turns and moves nothing), of x, y, z, of 12 or 16 numbers row by row, or of
    another."""

    FIELDS = tuple("r%d_c%d" % (row, column) for row in (1, 2, 3) for column in (1, 2, 3, 4))

    def __init__(self, *values: Any):
        if len(values) == 3:
            values = (1, 0, 0, values[0], 0, 1, 0, values[1], 0, 0, 1, values[2])
        elif len(values) == 1:
            values = tuple(values[0])
        if not values:
            values = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)
        super().__init__(*(values[:12] if len(values) == 16 else values))

    def toVector(self) -> List[float]:
        """16 numbers, row by row."""
        return [getattr(self, name) for name in self.FIELDS] + LAST_ROW

    def __len__(self):
        return 16

    def rows(self) -> List[List[float]]:
        numbers = self.toVector()
        return [numbers[at:at + 4] for at in range(0, 16, 4)]

    def __repr__(self):
        return "\n".join("[%s]" % ", ".join("%g" % value for value in row) for row in self.rows())

    def __mul__(self, other: Any):
        if isinstance(other, Transform):
            return Transform([v for row in multiply(self.rows(), other.rows()) for v in row])
        x, y, z = other
        return Position3D(*[row[0] * x + row[1] * y + row[2] * z + row[3]
                            for row in self.rows()[:3]])

    def __imul__(self, other: "Transform"):
        return self._become(self * other)

    def rotation(self) -> Rotation:
        return fromRows(self.rows()[:3])

    def position(self) -> Position3D:
        return Position3D(self.r1_c4, self.r2_c4, self.r3_c4)

    def inverse(self) -> "Transform":
        turned = self.rotation().transpose()
        return transformFromRotationPosition3D(turned, -(turned * self.position()))

    def diff(self, other: "Transform") -> "Transform":
        """`other` in this one's frame."""
        return self.inverse() * other

    def norm(self) -> float:
        return self.position().norm()

    def determinant(self) -> float:
        return self.rotation().determinant()

    def distanceSquared(self, other: "Transform") -> float:
        """Between the origins."""
        return self.position().distanceSquared(other.position())

    def distance(self, other: "Transform") -> float:
        return math.sqrt(self.distanceSquared(other))

    def isTransform(self, epsilon: float = NEAR) -> bool:
        return self.rotation().isRotation(epsilon)

    def normalizeTransform(self) -> "Transform":
        """Its rotation made exactly orthogonal again, in place."""
        turned = self.rotation().normalizeRotation()
        return self._become(transformFromRotationPosition3D(turned, self.position()).toVector()[:12])

    @staticmethod
    def fromRotX(angle: float) -> "Transform":
        return transformFromRotX(angle)

    @staticmethod
    def fromRotY(angle: float) -> "Transform":
        return transformFromRotY(angle)

    @staticmethod
    def fromRotZ(angle: float) -> "Transform":
        return transformFromRotZ(angle)

    @staticmethod
    def from3DRotation(wx: float, wy: float, wz: float) -> "Transform":
        return transformFrom3DRotation(wx, wy, wz)

    @staticmethod
    def fromPosition(*numbers: float) -> "Transform":
        return transformFromPosition(*numbers)


def transformFromRotationPosition3D(rotation: Rotation, *position: Any) -> Transform:
    """`position` as three numbers or a Position3D."""
    where = Position3D(*position)
    rows = [row + [value] for row, value in zip(rotation.rows(), where)]
    return Transform([value for row in rows for value in row])


def transformFromRotation(rotation: Rotation) -> Transform:
    return transformFromRotationPosition3D(rotation, Position3D())


def transformFromRotX(angle: float) -> Transform:
    return transformFromRotation(rotationFromRotX(angle))


def transformFromRotY(angle: float) -> Transform:
    return transformFromRotation(rotationFromRotY(angle))


def transformFromRotZ(angle: float) -> Transform:
    return transformFromRotation(rotationFromRotZ(angle))


def transformFrom3DRotation(wx: float, wy: float, wz: float) -> Transform:
    return transformFromRotation(rotationFrom3DRotation(wx, wy, wz))


def transformFromRotation3D(angles: Rotation3D) -> Transform:
    return transformFrom3DRotation(*angles)


def transformFromPosition(x: float, y: float, z: float, wx: float = 0.0, wy: float = 0.0,
                          wz: float = 0.0) -> Transform:
    return transformFromRotationPosition3D(rotationFrom3DRotation(wx, wy, wz), x, y, z)


def transformFromPosition3D(position: Position3D) -> Transform:
    return Transform(*position)


def transformFromPosition6D(position: Position6D) -> Transform:
    return transformFromPosition(*position)


def transformFromPose2D(pose: Pose2D) -> Transform:
    return transformFromPosition(pose.x, pose.y, 0.0, 0.0, 0.0, pose.theta)


def transformFromQuaternion(quaternion: Quaternion) -> Transform:
    return transformFromRotation(rotationFromQuaternion(quaternion))


def transformFromRotVec(*arguments: Any) -> Transform:
    """(axis, angle, position), (axis, angle) or (position): a turn about axis 1 to 3, x to z, then
    a move. Raises RuntimeError for another axis."""
    if len(arguments) == 1:
        return transformFromPosition3D(arguments[0])
    axis, angle = arguments[:2]
    if axis not in (1, 2, 3):
        raise RuntimeError("ALMath: expected an axis from 1 to 3, found %s" % axis)
    turn = (rotationFromRotX, rotationFromRotY, rotationFromRotZ)[axis - 1](angle)
    return transformFromRotationPosition3D(turn, *(arguments[2:] or (Position3D(),)))


def rotationFromTransform(transform: Transform) -> Rotation:
    return transform.rotation()


def rotation3DFromTransform(transform: Transform) -> Rotation3D:
    return rotation3DFromRotation(transform.rotation())


def position3DFromTransform(transform: Transform) -> Position3D:
    return transform.position()


def position2DFromTransform(transform: Transform) -> Position2D:
    return Position2D(transform.r1_c4, transform.r2_c4)


def position6DFromTransform(transform: Transform) -> Position6D:
    return Position6D(list(transform.position()) + list(rotation3DFromTransform(transform)))


def pose2DFromTransform(transform: Transform) -> Pose2D:
    """Its place on the floor, and the heading of its axis x."""
    return Pose2D(transform.r1_c4, transform.r2_c4,
                  math.atan2(transform.r2_c1, transform.r1_c1))


def quaternionFromTransform(transform: Transform) -> Quaternion:
    return quaternionFromRotation(transform.rotation())


def transformInverse(transform: Transform) -> Transform:
    return transform.inverse()


def transformDiff(a: Transform, b: Transform) -> Transform:
    return a.diff(b)


def transformPreMultiply(a: Transform, b: Transform) -> None:
    """b becomes a * b."""
    b._become((a * b).toVector()[:12])


def transformDistance(a: Transform, b: Transform) -> float:
    return a.distance(b)


def transformDistanceSquared(a: Transform, b: Transform) -> float:
    return a.distanceSquared(b)


def transformDeterminant(transform: Transform) -> float:
    return transform.determinant()


def determinant(matrix: Any) -> float:
    """Of a rotation, of a transform or of its numbers."""
    known = hasattr(matrix, "determinant")
    return matrix.determinant() if known else Transform(matrix).determinant()


def transformToFloatVector(transform: Transform) -> List[float]:
    return transform.toVector()


def normalizeTransform(transform: Transform) -> Transform:
    return transform.normalizeTransform()


def transformDifferenceInPosition6D(a: Transform, b: Transform) -> Position6D:
    """b in a's frame."""
    return position6DFromTransform(a.diff(b))


def position6DFromTransformDiff(b: Transform, c: Transform) -> Position6D:
    """What leads from frame b to frame c, both seen from a frame A and the answer, too: the shift
    of the origin [m], and the axis of the turn times its angle [rad]."""
    turn = transformFromRotation(c.rotation() * b.rotation().transpose())
    return Position6D(list(c.position() - b.position()) + transformLogarithm(turn).toVector()[3:])


def transformLogarithm(transform: Transform) -> Velocity6D:
    """The steady motion that leads there in one second."""
    quaternion = quaternionFromTransform(transform)
    half = math.sqrt(quaternion.x ** 2 + quaternion.y ** 2 + quaternion.z ** 2)
    angle = 2 * math.atan2(half, quaternion.w)
    factor = angle / half if half > 1e-9 else 2.0
    turn = Position3D(quaternion.x, quaternion.y, quaternion.z) * factor
    move = transform.position()
    cross = turn.crossProduct(move)
    if angle > 1e-4:
        share = (1 - angle / 2 / math.tan(angle / 2)) / angle ** 2
    else:
        share = 1 / 12
    return Velocity6D(list(move - cross * 0.5 + turn.crossProduct(cross) * share) + list(turn))


def velocityExponential(velocity: Velocity6D) -> Transform:
    """Where that steady motion has led after one second."""
    numbers = velocity.toVector()
    move, turn = Position3D(numbers[:3]), Position3D(numbers[3:])
    angle = turn.norm()
    if angle < 1e-9:
        return transformFromPosition3D(move)
    cross = turn.crossProduct(move)
    along = (move + cross * ((1 - math.cos(angle)) / angle ** 2) +
             turn.crossProduct(cross) * ((angle - math.sin(angle)) / angle ** 3))
    return transformFromRotationPosition3D(rotationFromAngleDirection(angle, turn), along)


def transformMean(a: Transform, b: Transform, share: float = 0.5) -> Transform:
    """Between the two: 0 is a, 1 is b."""
    return a * velocityExponential(transformLogarithm(a.diff(b)) * share)
