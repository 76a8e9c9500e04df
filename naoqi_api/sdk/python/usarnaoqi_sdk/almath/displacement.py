"""Turns and shifts in one."""

from typing import Any

from .record import NEAR
from .rotations import Quaternion, quaternionFromRotation3D
from .tools import position3DFromPosition6D, rotation3DFromPosition6D
from .vectors import Position3D, Position6D


class Displacement:
    """A turn Q, then a shift P [m]; a * b: first b, then a. Made of nothing, of P, of P and Q."""

    def __init__(self, shift: Any = None, turn: Any = None):
        self.P = Position3D() if shift is None else Position3D(shift)
        self.Q = Quaternion() if turn is None else Quaternion(turn)

    def __mul__(self, other: "Displacement") -> "Displacement":
        return Displacement(self.P + _turned(self.Q, other.P), self.Q * other.Q)

    def isNear(self, other: "Displacement", epsilon: float = NEAR) -> bool:
        """q and -q are the same turn."""
        near = self.Q.isNear(other.Q, epsilon) or self.Q.isNear(other.Q * -1.0, epsilon)
        return near and self.P.isNear(other.P, epsilon)


def _turned(turn: Quaternion, place: Position3D) -> Position3D:
    q = turn * Quaternion(0, *place) * turn.inverse()
    return Position3D(q.x, q.y, q.z)


def quaternionPosition3DFromPosition6D(position: Position6D, turn: Quaternion,
                                       place: Position3D) -> None:
    """Into the last two."""
    turn._become(quaternionFromRotation3D(rotation3DFromPosition6D(position)))
    place._become(position3DFromPosition6D(position))
