"""What words and operators meant in Python 2, for converted programs."""

import builtins
import numbers
import sys
from collections import namedtuple
from functools import cmp_to_key
from typing import Any, Callable, List, Optional

__all__ = ["cmp", "file", "ord", "py2_divide", "py2_version_info", "reload", "sorted", "unichr"]

VersionInfo = namedtuple("VersionInfo", "major minor micro releaselevel serial")
py2_version_info = VersionInfo(2, 7, 18, "final", 0)  # the last one


def py2_divide(a: Any, b: Any) -> Any:
    """a / b: of whole numbers the whole part, downwards."""
    if isinstance(a, numbers.Integral) and isinstance(b, numbers.Integral):
        return a // b
    return a / b


def cmp(a: Any, b: Any) -> int:
    return (a > b) - (a < b)


def ord(character: Any) -> int:  # pylint: disable=redefined-builtin
    """Of a byte, too, which is a number already in Python 3."""
    return character if isinstance(character, int) else builtins.ord(character)


def sorted(values: Any, key: Any = None, reverse: bool = False,  # pylint: disable=redefined-builtin
           cmp: Optional[Callable[[Any, Any], int]] = None) -> List[Any]:
    """With `cmp`, also as the second argument."""
    if key is not None and cmp is None and _takesTwo(key):
        key, cmp = None, key
    return builtins.sorted(values, key=cmp_to_key(cmp) if cmp else key, reverse=reverse)


def _takesTwo(function: Any) -> bool:
    return getattr(getattr(function, "__code__", None), "co_argcount", 1) == 2


def file(name: str, mode: str = "r", *rest: Any) -> Any:
    return open(name, mode, *rest)


def reload(module: Any) -> Any:
    """Modules stay as they are; `reload(sys)` was the way to setdefaultencoding()."""
    if module is sys and not hasattr(sys, "setdefaultencoding"):
        sys.setdefaultencoding = lambda _: None  # type: ignore[attr-defined]
    return module


unichr = chr
