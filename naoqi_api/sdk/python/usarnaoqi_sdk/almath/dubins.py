"""The shortest way between two poses for who can not turn on the spot: an arc, a straight line or a
counter-arc, and an arc again (Dubins, 1957).

With the radius as unit and headings a, b against the line of length d between the two poses, each
word such as left-straight-right gives the three lengths in closed form.
"""

import math
from typing import Callable, List, Optional, Tuple

from .vectors import Pose2D

Lengths = Tuple[float, float, float]  # angles of arcs [rad], straight lines in radii


def getDubinsSolutions(target: Pose2D, radius: float) -> List[Pose2D]:
    """Where each of the three parts of the shortest way from the origin ends, seen from there.
    Raises RuntimeError unless the radius [m] is positive."""
    if radius <= 0:
        raise RuntimeError("ALMath: the radius of a Dubins way must be positive")
    d = math.hypot(target.x, target.y) / radius
    line = math.atan2(target.y, target.x)
    a, b = _turn(-line), _turn(target.theta - line)
    found = [(sum(lengths), word, lengths) for word, calc in _WORDS.items()
             for lengths in [calc(a, b, d)] if lengths]
    _, word, lengths = min(found)
    poses, pose = [], Pose2D()
    for part, length in zip(word, lengths):
        pose = pose * _move(part, length, radius)
        poses.append(pose)
    return poses


def _move(part: str, length: float, radius: float) -> Pose2D:
    if part == "S":
        return Pose2D(length * radius, 0, 0)
    side = 1 if part == "L" else -1
    return Pose2D(radius * math.sin(length), side * radius * (1 - math.cos(length)), side * length)


def _turn(angle: float) -> float:
    """From 0 to a full turn; a turn that is missing by rounding alone is none."""
    rest = angle % (2 * math.pi)
    return 0.0 if 2 * math.pi - rest < 1e-12 else rest


def _sameSides(a: float, b: float, d: float) -> Optional[Lengths]:
    """Left, straight, left: the line is as the one between the circles' centres."""
    x, y = d + math.sin(a) - math.sin(b), math.cos(b) - math.cos(a)
    line = math.atan2(y, x)
    return _turn(line - a), math.hypot(x, y), _turn(b - line)


def _otherSides(a: float, b: float, d: float) -> Optional[Lengths]:
    """Left, straight, right: the line passes between the circles, if they are apart."""
    x, y = d + math.sin(a) + math.sin(b), -math.cos(a) - math.cos(b)
    square = x * x + y * y - 4
    if square < 0:
        return None
    straight = math.sqrt(square)
    line = math.atan2(y, x) + math.atan2(2, straight)
    return _turn(line - a), straight, _turn(line - b)


def _threeArcs(a: float, b: float, d: float) -> Optional[Lengths]:
    """Left, right, left: the middle circle touches the other two, if they are near."""
    x, y = d + math.sin(a) - math.sin(b), math.cos(b) - math.cos(a)
    share = math.hypot(x, y) / 4
    if share > 1:
        return None
    aside = math.acos(share)
    line = math.atan2(y, x)
    return _turn(line + aside + math.pi / 2 - a), math.pi + 2 * aside, \
        _turn(b - line + aside - 3 * math.pi / 2)


def _mirrored(calc: Callable[[float, float, float], Optional[Lengths]]):
    """The same with left and right exchanged: the world seen in a mirror along the line."""
    return lambda a, b, d: calc(_turn(-a), _turn(-b), d)


_WORDS = {"LSL": _sameSides, "RSR": _mirrored(_sameSides), "LSR": _otherSides,
          "RSL": _mirrored(_otherSides), "LRL": _threeArcs, "RLR": _mirrored(_threeArcs)}
