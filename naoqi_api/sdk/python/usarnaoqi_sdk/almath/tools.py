"""What is left of almath: angles, conversions between the smaller types, constants."""

import math
from typing import Any, List, Sequence

from .record import NEAR
from .vectors import Pose2D, Position2D, Position3D, Position6D, Rotation3D, Velocity6D

PI, PI_2, PI_4 = math.pi, math.pi / 2, math.pi / 4
TWO_PI = _2_PI_ = 2 * math.pi
TO_RAD, TO_DEG = math.pi / 180, 180 / math.pi

AXIS_MASK_X, AXIS_MASK_Y, AXIS_MASK_Z = 1, 2, 4
AXIS_MASK_WX, AXIS_MASK_WY, AXIS_MASK_WZ, AXIS_MASK_WYWZ = 8, 16, 32, 48
AXIS_MASK_XY, AXIS_MASK_VEL, AXIS_MASK_ROT, AXIS_MASK_ALL, AXIS_MASK_NONE = 3, 7, 56, 63, 0


def modulo2PI(angle: float) -> float:
    """The same direction, from -pi (left out) to pi."""
    rest = math.fmod(angle, 2 * math.pi)
    if rest > math.pi:
        return rest - 2 * math.pi
    return rest + 2 * math.pi if rest <= -math.pi else rest


def meanAngle(angles: Sequence[float]) -> float:
    """Raises RuntimeError where the directions cancel out."""
    return weightedMeanAngle(angles, [1.0] * len(angles))


def weightedMeanAngle(angles: Sequence[float], weights: Sequence[float]) -> float:
    x = sum(weight * math.cos(angle) for angle, weight in zip(angles, weights))
    y = sum(weight * math.sin(angle) for angle, weight in zip(angles, weights))
    if math.hypot(x, y) < 1e-9:
        raise RuntimeError("ALMath: these angles have no mean")
    return math.atan2(y, x)


def clipData(low: float, high: float, value: float) -> float:
    return max(low, min(high, value))


def norm(vector: Any) -> float:
    return vector.norm()


def normalize(vector: Any) -> Any:
    return vector.normalize()


def distance(a: Any, b: Any) -> float:
    return a.distance(b)


def distanceSquared(a: Any, b: Any) -> float:
    return a.distanceSquared(b)


def dotProduct(a: Any, b: Any) -> float:
    return a.dotProduct(b)


def crossProduct(a: Any, b: Any) -> Any:
    return a.crossProduct(b)


def isUnitVector(vector: Any, epsilon: float = NEAR) -> bool:
    return vector.isUnitVector(epsilon)


def isOrthogonal(a: Any, b: Any, epsilon: float = NEAR) -> bool:
    return a.isOrthogonal(b, epsilon)


def pose2DInverse(pose: Pose2D) -> Pose2D:
    return pose.inverse()


pinv = pose2DInverse


def pose2DDiff(a: Pose2D, b: Pose2D) -> Pose2D:
    """b in a's frame."""
    return a.diff(b)


pose2dDiff = pose2DDiff


def pose2dInvertInPlace(pose: Pose2D) -> None:
    pose._become(pose.inverse())


def diff(a: Any, b: Any) -> Any:
    return a.diff(b)


def changeReferencePose2D(theta: float, pose: Pose2D) -> Pose2D:
    """A displacement seen from a frame turned by `theta`."""
    moved = Pose2D(0, 0, theta) * Position2D(pose.x, pose.y)
    return Pose2D(moved.x, moved.y, pose.theta)


def position2DFromPose2D(pose: Pose2D) -> Position2D:
    return Position2D(pose.x, pose.y)


def pose2DFromPosition2D(position: Position2D, theta: float = 0.0) -> Pose2D:
    return Pose2D(position.x, position.y, theta)


def pose2DFromPosition6D(position: Position6D) -> Pose2D:
    return Pose2D(position.x, position.y, position.wz)


def position6DFromPose2D(pose: Pose2D) -> Position6D:
    return Position6D(pose.x, pose.y, 0, 0, 0, pose.theta)


def position3DFromPosition6D(position: Position6D) -> Position3D:
    return Position3D(position.x, position.y, position.z)


def position6DFromPosition3D(position: Position3D) -> Position6D:
    return Position6D(position.x, position.y, position.z, 0, 0, 0)


def position6DFromVelocity6D(velocity: Velocity6D) -> Position6D:
    """Number by number: where one second leads."""
    return Position6D(velocity.toVector())


def pointMassRotationalInertia(mass: float, place: Position3D, target: Any = None) -> List[float]:
    """The inertia about the origin [kg m^2] of `mass` [kg] at `place` [m]: 9 numbers, row by row,
    which also replace those of `target`."""
    p = list(place)
    square = sum(value * value for value in p)
    inertia = [mass * ((square if i == j else 0) - p[i] * p[j]) for i in range(3) for j in range(3)]
    if target is not None:
        target[:] = inertia
    return inertia


def rotation3DFromPosition6D(position: Position6D) -> Rotation3D:
    return Rotation3D(position.wx, position.wy, position.wz)


def vectorFloat(values: Sequence[float] = ()) -> List[float]:
    """Lists are lists here."""
    return [float(value) for value in values]
