"""Aldebaran's almath in pure Python: positions, rotations, transforms and what relates them."""

from .dubins import getDubinsSolutions  # noqa: F401
from .footsteps import avoidFootCollision, clipFootWithEllipse  # noqa: F401
from .rotations import *  # noqa: F401,F403
from .tools import *  # noqa: F401,F403
from .tools import _2_PI_  # noqa: F401
from .transforms import *  # noqa: F401,F403
from .vectors import *  # noqa: F401,F403

_INNER = {"Record", "Vector", "Any", "List", "Sequence", "math", "multiply", "fromRows", "NEAR",
          "LAST_ROW", "dubins", "footsteps", "record", "rotations", "tools", "transforms", "vectors"}
__all__ = sorted(name for name in globals() if not name.startswith("_") and name not in _INNER)
__all__.append("_2_PI_")
