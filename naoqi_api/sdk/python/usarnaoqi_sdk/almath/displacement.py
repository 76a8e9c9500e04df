"""Pairs: of a turn and a shift, of a place and a motion."""

from typing import Any

from .record import NEAR
from .rotations import Quaternion, quaternionFromRotation3D
from .tools import position3DFromPosition6D, rotation3DFromPosition6D
from .transforms import Transform
from .vectors import Position3D, Position6D, Velocity6D


class Displacement:
    """A turn Q, then a shift P [m]; a * b: first b, then a. Made of nothing, of P, of P and Q."""

    def __init__(self, shift: Any = None, turn: Any = None):
        self.P = Position3D() if shift is None else Position3D(shift)
        self.Q = Quaternion() if turn is None else Quaternion(turn)

    def __mul__(self, other: "Displacement") -> "Displacement":
        return Displacement(self.P + self.Q * other.P, self.Q * other.Q)

    def isNear(self, other: "Displacement", epsilon: float = NEAR) -> bool:
        return self.Q.isNear(other.Q, epsilon) and self.P.isNear(other.P, epsilon)


class TransformAndVelocity6D:
    """Where a body is, T, and how it moves, V."""

    def __init__(self, place: Any = None, motion: Any = None):
        self.T = Transform() if place is None else Transform(place)
        self.V = Velocity6D() if motion is None else Velocity6D(motion)

    def isNear(self, other: "TransformAndVelocity6D", epsilon: float = NEAR) -> bool:
        return self.T.isNear(other.T, epsilon) and self.V.isNear(other.V, epsilon)


def quaternionPosition3DFromPosition6D(position: Position6D, turn: Quaternion,
                                       place: Position3D) -> None:
    """Into the last two."""
    turn._become(quaternionFromRotation3D(rotation3DFromPosition6D(position)))
    place._become(position3DFromPosition6D(position))
