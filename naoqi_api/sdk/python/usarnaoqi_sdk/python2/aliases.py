"""What moved since: modules and functions under the names of Python 2's days, where they are
installed under new ones."""

import importlib
import importlib.util
import string
import sys
import time
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from typing import Any, Optional

MODULES = {"Image": "PIL.Image", "ImageDraw": "PIL.ImageDraw", "ImageFont": "PIL.ImageFont",
           "ImageTk": "PIL.ImageTk", "ImageFilter": "PIL.ImageFilter",
           "ImageOps": "PIL.ImageOps", "ImageChops": "PIL.ImageChops"}
FUNCTIONS = {"PIL.Image": [("fromstring", "frombytes"), ("Image.tostring", "Image.tobytes")]}


class _Alias(Loader):
    """A module under its old name."""

    def __init__(self, new_name: str):
        self._new_name = new_name

    def create_module(self, spec: ModuleSpec) -> Any:
        return importlib.import_module(self._new_name)

    def exec_module(self, module: Any) -> None:
        """It has been executed under its new name."""


class _Patched(Loader):
    """A module whose functions have their old names, too."""

    def __init__(self, name: str, loader: Any):
        self._name, self._loader = name, loader

    def create_module(self, spec: ModuleSpec) -> Any:
        return self._loader.create_module(spec)

    def exec_module(self, module: Any) -> None:
        self._loader.exec_module(module)
        for old, new in FUNCTIONS[self._name]:
            owner, _, name = old.rpartition(".")
            target = getattr(module, owner) if owner else module
            if not hasattr(target, name):
                setattr(target, name, getattr(target, new.rpartition(".")[2]))


class Finder(MetaPathFinder):
    """Finds a module's old name if there is the new one."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if name in FUNCTIONS:
            spec = PathFinder.find_spec(name, path, target)
            if spec and spec.loader:
                spec.loader = _Patched(name, spec.loader)
            return spec
        if name not in MODULES or PathFinder.find_spec(name) or not _isThere(MODULES[name]):
            return None
        return ModuleSpec(name, _Alias(MODULES[name]))


def _isThere(name: str) -> bool:
    try:
        return importlib.util.find_spec(name) is not None
    except ImportError:
        return False


def _restore() -> None:
    """What modules had that every Python has loaded."""
    old = {"letters": string.ascii_letters, "lowercase": string.ascii_lowercase,
           "uppercase": string.ascii_uppercase, "maketrans": str.maketrans,
           "join": lambda words, between=" ": between.join(words), "atoi": int, "atof": float}
    for name in ("split", "strip", "replace", "find", "lower", "upper", "zfill"):
        old[name] = getattr(str, name)
    for name, value in old.items():
        setattr(string, name, value)
    sys.maxint = sys.maxsize  # type: ignore[attr-defined]
    if not hasattr(time, "clock"):
        time.clock = time.process_time  # type: ignore[attr-defined]


def install() -> None:
    _restore()
    sys.meta_path.insert(0, Finder())
