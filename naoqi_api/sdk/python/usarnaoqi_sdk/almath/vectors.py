"""Positions, poses in the plane, velocities. Metres, radians, seconds."""

import math
from typing import Any

from .record import Vector


class Position2D(Vector):
    FIELDS = ("x", "y")

    def crossProduct(self, other: "Position2D") -> float:
        return self.x * other.y - self.y * other.x

    def getAngle(self) -> float:
        return math.atan2(self.y, self.x)

    @staticmethod
    def fromPolarCoordinates(radius: float, angle: float) -> "Position2D":
        return Position2D(radius * math.cos(angle), radius * math.sin(angle))


class Position3D(Vector):
    FIELDS = ("x", "y", "z")

    def crossProduct(self, other: "Position3D") -> "Position3D":
        return Position3D(self.y * other.z - self.z * other.y, self.z * other.x - self.x * other.z,
                          self.x * other.y - self.y * other.x)


class Position6D(Vector):
    """A position, and a rotation about x, then y, then z of the fixed frame."""

    FIELDS = ("x", "y", "z", "wx", "wy", "wz")

    def distanceSquared(self, other: Any) -> float:
        """Between the points alone."""
        return sum((a - b) ** 2 for a, b in zip(self.toVector()[:3], other.toVector()[:3]))


class Rotation3D(Vector):
    """Rotations about x, then y, then z of the fixed frame."""

    FIELDS = ("wx", "wy", "wz")


class Velocity3D(Vector):
    FIELDS = ("xd", "yd", "zd")


class Velocity6D(Vector):
    FIELDS = ("xd", "yd", "zd", "wxd", "wyd", "wzd")


class Pose2D(Vector):
    """A place and a heading in the plane; `a * b` is b, given in a's frame, seen from outside."""

    FIELDS = ("x", "y", "theta")

    def __mul__(self, other: Any):
        if isinstance(other, Pose2D):
            moved = self * Position2D(other.x, other.y)
            return Pose2D(moved.x, moved.y, self.theta + other.theta)
        if isinstance(other, Position2D):
            c, s = math.cos(self.theta), math.sin(self.theta)
            return Position2D(self.x + c * other.x - s * other.y,
                              self.y + s * other.x + c * other.y)
        return Vector.__mul__(self, other)

    def inverse(self) -> "Pose2D":
        c, s = math.cos(self.theta), math.sin(self.theta)
        return Pose2D(-c * self.x - s * self.y, s * self.x - c * self.y, -self.theta)

    def diff(self, other: "Pose2D") -> "Pose2D":
        """`other` in this one's frame."""
        return self.inverse() * other

    def getAngle(self) -> float:
        """The direction in which the place lies."""
        return math.atan2(self.y, self.x)

    def norm(self) -> float:
        return math.hypot(self.x, self.y)

    def distanceSquared(self, other: Any) -> float:
        return (self.x - other.x) ** 2 + (self.y - other.y) ** 2

    def toPosition2D(self) -> Position2D:
        return Position2D(self.x, self.y)

    @staticmethod
    def fromPolarCoordinates(radius: float, angle: float) -> "Pose2D":
        return Pose2D(radius * math.cos(angle), radius * math.sin(angle), angle)


class PositionAndVelocity(Vector):
    FIELDS = ("q", "dq")
