"""What all types of almath share: named numbers that can be changed, compared, added, listed."""

import math
from typing import Any, Callable, Iterable, List, Tuple

NEAR = 1e-4  # the tolerance of isNear() when none is given


class Record:
    """Numbers by name; made of nothing (zeros), of the numbers, of a list of them, or of another."""

    FIELDS: Tuple[str, ...] = ()

    def __init__(self, *values: Any):
        if len(values) == 1 and isinstance(values[0], Iterable):
            values = tuple(values[0])
        if not values:
            values = self._nothing()
        if len(values) == 1 and len(self.FIELDS) > 1:
            values = values * len(self.FIELDS)
        if len(values) != len(self.FIELDS):
            raise RuntimeError("ALMath: %s is made of %d numbers, not %d" % (
                type(self).__name__, len(self.FIELDS), len(values)))
        for name, value in zip(self.FIELDS, values):
            setattr(self, name, float(value))

    def _nothing(self) -> tuple:
        return (0.0,) * len(self.FIELDS)

    def toVector(self) -> List[float]:
        return [getattr(self, name) for name in self.FIELDS]

    def writeToVector(self, target: Any, *_: Any) -> None:
        target.extend(self.toVector())

    def __iter__(self):
        return iter(self.toVector())

    def __len__(self):
        return len(self.FIELDS)

    def __repr__(self):
        return "%s(%s)" % (type(self).__name__, ", ".join(
            "%s=%g" % (name, value) for name, value in zip(self.FIELDS, self)))

    def __eq__(self, other: Any):
        return type(other) is type(self) and self.toVector() == other.toVector()

    def __ne__(self, other: Any):
        return not self == other

    __hash__ = None  # type: ignore[assignment]  # its numbers may change

    def isNear(self, other: Any, epsilon: float = NEAR) -> bool:
        return all(abs(a - b) <= epsilon for a, b in zip(self, other))

    def _become(self, other: Any) -> Any:
        for name, value in zip(self.FIELDS, other):
            setattr(self, name, value)
        return self


class Vector(Record):
    """A record that is added and scaled number by number."""

    def __add__(self, other: Any):
        return self._with(other, lambda a, b: a + b)

    def __sub__(self, other: Any):
        return self._with(other, lambda a, b: a - b)

    def __pos__(self):
        return type(self)(*self)

    def __neg__(self):
        return type(self)(*[-value for value in self])

    def __mul__(self, factor: float):
        return type(self)(*[value * factor for value in self])

    __rmul__ = __mul__

    def __truediv__(self, divisor: float):
        if divisor == 0:
            raise RuntimeError("ALMath: %s divided by zero" % type(self).__name__)
        return type(self)(*[value / divisor for value in self])

    __div__ = __truediv__

    def __iadd__(self, other: Any):
        return self._become(self + other)

    def __isub__(self, other: Any):
        return self._become(self - other)

    def __imul__(self, factor: Any):
        return self._become(self * factor)

    def __itruediv__(self, divisor: float):
        return self._become(self / divisor)

    def norm(self) -> float:
        return math.sqrt(sum(value * value for value in self))

    def normalize(self) -> Any:
        """The same direction with length 1. Raises RuntimeError for a zero vector."""
        length = self.norm()
        if length == 0:
            raise RuntimeError("ALMath: %s of length zero has no direction" % type(self).__name__)
        return type(self)(*[value / length for value in self])

    def distanceSquared(self, other: Any) -> float:
        return sum((a - b) ** 2 for a, b in zip(self, other))

    def distance(self, other: Any) -> float:
        return math.sqrt(self.distanceSquared(other))

    def dotProduct(self, other: Any) -> float:
        return sum(a * b for a, b in zip(self, other))

    def isUnitVector(self, epsilon: float = NEAR) -> bool:
        return abs(self.norm() - 1) <= epsilon

    def isOrthogonal(self, other: Any, epsilon: float = NEAR) -> bool:
        return abs(self.dotProduct(other)) <= epsilon

    def _with(self, other: Any, combine: Callable[[float, float], float]) -> Any:
        if len(other) != len(self):
            raise RuntimeError("ALMath: %r and %r do not go together" % (self, other))
        return type(self)(*[combine(a, b) for a, b in zip(self, other)])
