"""Aldebaran's almath in pure Python: positions, rotations, transforms and what relates them."""

from .displacement import *  # noqa: F401,F403
from .dubins import getDubinsSolutions  # noqa: F401
from .footsteps import avoidFootCollision, clipFootWithEllipse  # noqa: F401
from .in_place import ALL as _IN_PLACE
from .references import *  # noqa: F401,F403
from .rotations import *  # noqa: F401,F403
from .tools import *  # noqa: F401,F403
from .tools import _2_PI_  # noqa: F401
from .transforms import *  # noqa: F401,F403
from .vectors import *  # noqa: F401,F403

globals().update(_IN_PLACE)

_INNER = {"Record", "Vector", "Any", "List", "Sequence", "math", "multiply", "fromRows", "NEAR",
          "LAST_ROW", "displacement", "dubins", "footsteps", "in_place", "record", "references",
          "rotations", "tools", "transforms", "vectors"}
__all__ = sorted(name for name in globals() if not name.startswith("_") and name not in _INNER)
__all__.append("_2_PI_")
