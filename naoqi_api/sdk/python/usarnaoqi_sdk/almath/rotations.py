"""Rotation matrices and quaternions."""

import math
from typing import Any, List, Sequence

from .record import NEAR, Record, Vector
from .vectors import Position3D, Rotation3D, Velocity3D


class Rotation(Record):
    """A matrix of 3 x 3, its numbers by row and column."""

    FIELDS = tuple("r%d_c%d" % (row, column) for row in (1, 2, 3) for column in (1, 2, 3))

    def __init__(self, *values: Any):
        super().__init__(*([0.0] * 9 if not values else values))
        if not values:
            self.r1_c1 = self.r2_c2 = self.r3_c3 = 1.0

    def rows(self) -> List[List[float]]:
        numbers = self.toVector()
        return [numbers[0:3], numbers[3:6], numbers[6:9]]

    def __mul__(self, other: Any):
        if isinstance(other, Rotation):
            return fromRows(multiply(self.rows(), other.rows()))
        x, y, z = other
        kind = Velocity3D if isinstance(other, Velocity3D) else Position3D
        return kind(*[row[0] * x + row[1] * y + row[2] * z for row in self.rows()])

    def __imul__(self, other: Any):
        return self._become(self * other)

    def transpose(self) -> "Rotation":
        return fromRows([list(column) for column in zip(*self.rows())])

    inverse = transpose

    def determinant(self) -> float:
        (a, b, c), (d, e, f), (g, h, i) = self.rows()
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)

    def normalizeRotation(self) -> "Rotation":
        """Made exactly orthogonal again, in place: the axis x keeps its direction."""
        first, second, _ = [Position3D(*column) for column in zip(*self.rows())]
        x = first.normalize()
        y = (second - x * x.dotProduct(second)).normalize()
        return self._become(_ofColumns(x, y, x.crossProduct(y)))

    def isRotation(self, epsilon: float = NEAR) -> bool:
        return (self * self.transpose()).isNear(Rotation(), epsilon) and \
            abs(self.determinant() - 1) <= epsilon

    @staticmethod
    def fromRotX(angle: float) -> "Rotation":
        return rotationFromRotX(angle)

    @staticmethod
    def fromRotY(angle: float) -> "Rotation":
        return rotationFromRotY(angle)

    @staticmethod
    def fromRotZ(angle: float) -> "Rotation":
        return rotationFromRotZ(angle)

    @staticmethod
    def fromRotXPi() -> "Rotation":
        """By exactly half a turn."""
        return Rotation(1, 0, 0, 0, -1, 0, 0, 0, -1)

    @staticmethod
    def fromRotYPi() -> "Rotation":
        return Rotation(-1, 0, 0, 0, 1, 0, 0, 0, -1)

    @staticmethod
    def fromRotZPi() -> "Rotation":
        return Rotation(-1, 0, 0, 0, -1, 0, 0, 0, 1)

    @staticmethod
    def fromRotZHalfPi() -> "Rotation":
        """By exactly a quarter of a turn."""
        return Rotation(0, -1, 0, 1, 0, 0, 0, 0, 1)

    @staticmethod
    def from3DRotation(wx: float, wy: float, wz: float) -> "Rotation":
        return rotationFrom3DRotation(wx, wy, wz)

    @staticmethod
    def fromAngleDirection(angle: float, x: float, y: float, z: float) -> "Rotation":
        return rotationFromAngleDirection(angle, x, y, z)

    @staticmethod
    def fromQuaternion(w: float, x: float, y: float, z: float) -> "Rotation":
        return rotationFromQuaternion(w, x, y, z)


class Quaternion(Vector):
    """w + x i + y j + z k; made of nothing it turns nothing."""

    FIELDS = ("w", "x", "y", "z")

    def _nothing(self) -> tuple:
        return (1.0, 0.0, 0.0, 0.0)

    def __mul__(self, other: Any):
        if isinstance(other, Position3D):
            return rotationFromQuaternion(self) * other
        if not isinstance(other, Quaternion):
            return Vector.__mul__(self, other)
        a, b = self, other
        return Quaternion(a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
                          a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
                          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
                          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w)

    def isNear(self, other: Any, epsilon: float = NEAR) -> bool:
        """q and -q turn alike."""
        return Vector.isNear(self, other, epsilon) or Vector.isNear(-self, other, epsilon)

    def inverse(self) -> "Quaternion":
        square = self.dotProduct(self)
        if square == 0:
            raise RuntimeError("ALMath: a zero quaternion has no inverse")
        return Quaternion(self.w / square, -self.x / square, -self.y / square, -self.z / square)

    @staticmethod
    def fromAngleAndAxisRotation(angle: float, x: float, y: float, z: float) -> "Quaternion":
        return quaternionFromAngleAndAxisRotation(angle, x, y, z)


def multiply(a: Sequence[Sequence[float]], b: Sequence[Sequence[float]]) -> List[List[float]]:
    columns = list(zip(*b))
    return [[sum(x * y for x, y in zip(row, column)) for column in columns] for row in a]


def fromRows(rows: Sequence[Sequence[float]]) -> Rotation:
    return Rotation([value for row in rows for value in row[:3]])


def _ofColumns(*columns: Position3D) -> Rotation:
    return fromRows([list(row) for row in zip(*columns)])


def rotationFromRotX(angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    return Rotation(1, 0, 0, 0, c, -s, 0, s, c)


def rotationFromRotY(angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    return Rotation(c, 0, s, 0, 1, 0, -s, 0, c)


def rotationFromRotZ(angle: float) -> Rotation:
    c, s = math.cos(angle), math.sin(angle)
    return Rotation(c, -s, 0, s, c, 0, 0, 0, 1)


def rotationFrom3DRotation(wx: float, wy: float, wz: float) -> Rotation:
    return rotationFromRotZ(wz) * rotationFromRotY(wy) * rotationFromRotX(wx)


def rotationFromRotation3D(angles: Rotation3D) -> Rotation:
    return rotationFrom3DRotation(*angles)


def rotation3DFromRotation(rotation: Rotation) -> Rotation3D:
    """Where y is turned by 90 degrees the turn about x is taken for 0."""
    rows = rotation.rows()
    wy = math.atan2(-rows[2][0], math.hypot(rows[0][0], rows[1][0]))
    if math.hypot(rows[0][0], rows[1][0]) < 1e-9:
        return Rotation3D(0.0, wy, math.atan2(-rows[0][1], rows[1][1]))
    return Rotation3D(math.atan2(rows[2][1], rows[2][2]), wy, math.atan2(rows[1][0], rows[0][0]))


def rotationFromAngleDirection(angle: float, *direction: Any) -> Rotation:
    """`direction` as three numbers or a Position3D; need not have length 1."""
    axis = Position3D(*direction).normalize()
    return rotationFromQuaternion(*quaternionFromAngleAndAxisRotation(angle, *axis))


def rotationFromAxesXY(x: Position3D, y: Position3D) -> Rotation:
    return _ofColumns(x, y, x.crossProduct(y))


def rotationFromAxesXZ(x: Position3D, z: Position3D) -> Rotation:
    return _ofColumns(x, z.crossProduct(x), z)


def rotationFromAxesYZ(y: Position3D, z: Position3D) -> Rotation:
    return _ofColumns(y.crossProduct(z), y, z)


def rotationFromAxesXYZ(x: Position3D, y: Position3D, z: Position3D) -> Rotation:
    return _ofColumns(x, y, z)


def rotationFromQuaternion(*quaternion: Any) -> Rotation:
    w, x, y, z = Quaternion(*quaternion).normalize()
    return Rotation(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),
                    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
                    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y))


def quaternionFromRotation(rotation: Rotation) -> Quaternion:
    """Of the two that turn alike, the one with w >= 0."""
    (a, b, c), (d, e, f), (g, h, i) = rotation.rows()
    squares = [1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i]  # of 2w, 2x, 2y, 2z
    largest = squares.index(max(squares))
    found = [(squares[0], h - f, c - g, d - b), (h - f, squares[1], d + b, c + g),
             (c - g, d + b, squares[2], h + f), (d - b, c + g, h + f, squares[3])][largest]
    quaternion = Quaternion(*found).normalize()
    return -quaternion if quaternion.w < 0 else quaternion


def quaternionFromAngleAndAxisRotation(angle: float, x: float, y: float, z: float) -> Quaternion:
    half = math.sin(angle / 2)
    return Quaternion(math.cos(angle / 2), x * half, y * half, z * half)


def angleAndAxisRotationFromQuaternion(quaternion: Quaternion) -> List[float]:
    """[angle, x, y, z]; a quaternion that turns nothing has the axis x."""
    w, x, y, z = quaternion.normalize()
    length = math.sqrt(x * x + y * y + z * z)
    if length < 1e-12:
        return [0.0, 1.0, 0.0, 0.0]
    return [2 * math.atan2(length, w), x / length, y / length, z / length]


def quaternionFromRotation3D(angles: Rotation3D) -> Quaternion:
    return quaternionFromRotation(rotationFromRotation3D(angles))


def rotation3DFromQuaternion(quaternion: Quaternion) -> Rotation3D:
    return rotation3DFromRotation(rotationFromQuaternion(quaternion))


def quaternionInverse(quaternion: Quaternion) -> Quaternion:
    return quaternion.inverse()


def applyRotation(rotation: Rotation, position: Position3D) -> Position3D:
    return rotation * position


def rotationInverse(rotation: Rotation) -> Rotation:
    return rotation.inverse()


def transpose(rotation: Rotation) -> Rotation:
    return rotation.transpose()


def normalizeRotation(rotation: Rotation) -> Rotation:
    return rotation.normalizeRotation()
