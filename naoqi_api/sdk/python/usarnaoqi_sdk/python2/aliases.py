"""Modules under the names of Python 2's days, where they are installed under new ones."""

import importlib
import importlib.util
import sys
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from typing import Any, Callable, Optional

from . import classes, old_library

MODULES = {"Image": "PIL.Image", "ImageDraw": "PIL.ImageDraw", "ImageFont": "PIL.ImageFont",
           "ImageTk": "PIL.ImageTk", "ImageFilter": "PIL.ImageFilter",
           "ImageOps": "PIL.ImageOps", "ImageChops": "PIL.ImageChops",
           "UserDict": "collections", "exceptions": "builtins",
           "email.MIMEAudio": "email.mime.audio", "email.MIMEBase": "email.mime.base",
           "email.MIMEImage": "email.mime.image", "email.MIMEMultipart": "email.mime.multipart",
           "email.MIMEText": "email.mime.text", "email.Encoders": "email.encoders",
           "email.Header": "email.header", "email.Utils": "email.utils"}


class _Alias(Loader):
    """A module under its old name."""

    def __init__(self, find: Callable[[], Any]):
        self._find = find

    def create_module(self, spec: ModuleSpec) -> Any:
        return self._find()

    def exec_module(self, module: Any) -> None:
        """It has been executed under its new name."""


class _Completed(Loader):
    """A module that has what it had, too."""

    def __init__(self, name: str, loader: Any):
        self._name, self._loader = name, loader

    def create_module(self, spec: ModuleSpec) -> Any:
        return self._loader.create_module(spec)

    def exec_module(self, module: Any) -> None:
        self._loader.exec_module(module)
        old_library.COMPLETED[self._name](module)


class Finder(MetaPathFinder):
    """Finds a module's old name if there is the new one."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Optional[ModuleSpec]:
        if name in old_library.COMPLETED:
            spec = PathFinder.find_spec(name, path, target)
            if spec and spec.loader:
                spec.loader = _Completed(name, spec.loader)
            return spec
        find = _old(name)
        if not find or PathFinder.find_spec(name, path):
            return None
        return ModuleSpec(name, _Alias(find))


def _old(name: str) -> Optional[Callable[[], Any]]:
    if name in old_library.MADE:
        return old_library.MADE[name]
    new = MODULES.get(name, "")
    return (lambda: importlib.import_module(new)) if new and _isThere(new) else None


def _isThere(name: str) -> bool:
    try:
        return importlib.util.find_spec(name) is not None
    except ImportError:
        return False


def install() -> None:
    """Once."""
    if any(isinstance(finder, Finder) for finder in sys.meta_path):
        return
    old_library.install()
    classes.install()
    sys.meta_path.insert(0, Finder())
