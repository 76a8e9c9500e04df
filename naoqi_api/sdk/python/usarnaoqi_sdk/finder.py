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


class FolderGuard(MetaPathFinder):
    """The first of sys.meta_path: a folder that is merely called `motion` is no module, though Python
    takes it for one where no file of that name is on the path."""

    def __init__(self, behind: Finder):
        self._behind = behind

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if name not in NAMES:
            return None
        found = PathFinder.find_spec(name, path, target)
        is_mere_folder = found is not None and found.origin is None
        return self._behind.find_spec(name, path, target) if is_mere_folder else None


def install() -> None:
    """Once, however often it is called."""
    if not any(isinstance(finder, Finder) for finder in sys.meta_path):
        finder = Finder()
        sys.meta_path.append(finder)
        sys.meta_path.insert(0, FolderGuard(finder))
