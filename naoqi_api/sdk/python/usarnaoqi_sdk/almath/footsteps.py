"""Where a foot may step: within an ellipse, and not onto the other foot. A move is the pose of the
swinging foot as the standing one sees it; both functions change it and tell whether they did."""

import math
from typing import List, Sequence, Tuple

from .vectors import Pose2D

Corners = List[Tuple[float, float]]
_HALVINGS = 30  # of the angle between one that is free and one that collides


def clipFootWithEllipse(maxFootX: float, maxFootY: float, move: Pose2D) -> bool:
    """Draws x and y in along their own direction, onto the ellipse of these half axes [m]."""
    share = math.hypot(move.x / maxFootX, move.y / maxFootY)
    if share <= 1:
        return False
    move.x, move.y = move.x / share, move.y / share
    return True


def avoidFootCollision(leftBox: Sequence[Pose2D], rightBox: Sequence[Pose2D], isLeftSupport: bool,
                       move: Pose2D) -> bool:
    """Turns the swinging foot back until the two do not overlap; nothing but theta changes. The
    boxes are the corners of each foot, in order around it and in its own frame."""
    standing, swinging = (leftBox, rightBox) if isLeftSupport else (rightBox, leftBox)
    fixed = [(corner.x, corner.y) for corner in standing]

    def collides(theta: float) -> bool:
        return _overlap(fixed, _placed(swinging, move.x, move.y, theta))

    if not collides(move.theta):
        return False
    free, meeting = 0.0, move.theta
    if not collides(free):
        for _ in range(_HALVINGS):
            middle = (free + meeting) / 2
            free, meeting = (free, middle) if collides(middle) else (middle, meeting)
    move.theta = free
    return True


def _placed(box: Sequence[Pose2D], x: float, y: float, theta: float) -> Corners:
    c, s = math.cos(theta), math.sin(theta)
    return [(x + c * corner.x - s * corner.y, y + s * corner.x + c * corner.y) for corner in box]


def _overlap(a: Corners, b: Corners) -> bool:
    """Two convex outlines do not if a side of one has all of the other beyond it."""
    for one in (a, b):
        for (x0, y0), (x1, y1) in zip(one, one[1:] + one[:1]):
            along = [[(y1 - y0) * x - (x1 - x0) * y for x, y in corners] for corners in (a, b)]
            if max(along[0]) <= min(along[1]) or max(along[1]) <= min(along[0]):
                return False
    return True
