"""What is given in a frame F, as seen from outside, where F is `frame`; and, "Transpose", the other
way round. But for transforms directions alone are meant: F's place counts for nothing. The result
also becomes that of a last argument, as in C++."""

from typing import Any

from .transforms import Transform
from .vectors import Position3D, Position6D, Velocity6D


def _told(result: Any, target: Any) -> Any:
    if target is not None:
        target._become(result)
    return result


def _turned(frame: Transform, six: Any) -> Any:
    """Both halves as vectors."""
    numbers, rotation = six.toVector(), frame.rotation()
    move, turn = rotation * Position3D(numbers[:3]), rotation * Position3D(numbers[3:])
    return type(six)(list(move) + list(turn))


def changeReferencePosition3D(frame: Transform, position: Position3D,
                              target: Any = None) -> Position3D:
    return _told(frame.rotation() * position, target)


def changeReferenceTransposePosition3D(frame: Transform, position: Position3D,
                                       target: Any = None) -> Position3D:
    return _told(frame.rotation().transpose() * position, target)


def changeReferencePosition6D(frame: Transform, position: Position6D,
                              target: Any = None) -> Position6D:
    return _told(_turned(frame, position), target)


def changeReferenceTransposePosition6D(frame: Transform, position: Position6D,
                                       target: Any = None) -> Position6D:
    return _told(_turned(frame.inverse(), position), target)


def changeReferenceVelocity6D(frame: Transform, velocity: Velocity6D,
                              target: Any = None) -> Velocity6D:
    return _told(_turned(frame, velocity), target)


def changeReferenceTransposeVelocity6D(frame: Transform, velocity: Velocity6D,
                                       target: Any = None) -> Velocity6D:
    return _told(_turned(frame.inverse(), velocity), target)


def changeReferenceTransform(frame: Transform, inside: Transform, target: Any = None) -> Transform:
    """frame * inside, its place too."""
    return _told(frame * inside, target)


def changeReferenceTransposeTransform(frame: Transform, outside: Transform,
                                      target: Any = None) -> Transform:
    """What changeReferenceTransform() makes `outside` of."""
    return _told(frame.inverse() * outside, target)
