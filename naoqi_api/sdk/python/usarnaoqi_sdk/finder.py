"""Offers `naoqi`, `qi`, `almath`, `motion` and `vision_definitions`, but only where nothing else
does: a program's own motion.py, or an installed libqi, comes first."""

import os
import sys
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from typing import Any, Optional

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "offered")
NAMES = frozenset({"almath", "motion", "naoqi", "qi", "vision_definitions"})


class Finder(MetaPathFinder):
    """The last of sys.meta_path, also when others are added behind it."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if name not in NAMES:
            return None
        return self._findElsewhere(name, path, target) or PathFinder.find_spec(name, [FOLDER])

    def _findElsewhere(self, name: str, path: Any, target: Any) -> Optional[ModuleSpec]:
        """What those added behind this one find; those before it have been asked."""
        behind = sys.meta_path[sys.meta_path.index(self) + 1:] if self in sys.meta_path else []
        for finder in behind:
            spec = finder.find_spec(name, path, target)
            if spec:
                return spec
        return None


def install() -> None:
    """Once, however often it is called."""
    if not any(isinstance(finder, Finder) for finder in sys.meta_path):
        sys.meta_path.append(Finder())
