"""Modules that moved since: old names for what is installed under a new one."""

import importlib
import importlib.util
import sys
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from typing import Any, Optional

NEW_NAMES = {"Image": "PIL.Image", "ImageDraw": "PIL.ImageDraw", "ImageFont": "PIL.ImageFont",
             "ImageTk": "PIL.ImageTk", "ImageFilter": "PIL.ImageFilter",
             "ImageOps": "PIL.ImageOps", "ImageChops": "PIL.ImageChops"}


class _Alias(Loader):
    def __init__(self, new_name: str):
        self._new_name = new_name

    def create_module(self, spec: ModuleSpec) -> Any:
        return importlib.import_module(self._new_name)

    def exec_module(self, module: Any) -> None:
        """It has been executed under its new name."""


class Finder(MetaPathFinder):
    """The last of sys.meta_path."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        new_name = NEW_NAMES.get(name)
        try:
            known = new_name and importlib.util.find_spec(new_name)
        except ImportError:
            known = None
        return ModuleSpec(name, _Alias(new_name)) if new_name and known else None


def install() -> None:
    sys.meta_path.append(Finder())
