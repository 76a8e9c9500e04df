"""What words and operators meant in Python 2, for converted programs."""

import builtins
import codecs
import numbers
import operator
import sys
from collections import namedtuple
from functools import cmp_to_key
from typing import Any, Callable, List, Optional, Tuple

__all__ = ["cmp", "file", "ord", "py2_decode", "py2_divide", "py2_encode", "py2_greater",
           "py2_greater_equal", "py2_less", "py2_less_equal", "py2_version_info", "reload",
           "sorted", "unichr"]

VersionInfo = namedtuple("VersionInfo", "major minor micro releaselevel serial")
py2_version_info = VersionInfo(2, 7, 18, "final", 0)  # the last one


def py2_divide(a: Any, b: Any) -> Any:
    """a / b: of whole numbers the whole part, downwards."""
    if isinstance(a, numbers.Integral) and isinstance(b, numbers.Integral):
        return a // b
    return a / b


def _rank(value: Any) -> Tuple[int, str]:
    """Where things of its type stand: nothing first, then numbers, then the others by name."""
    if value is None:
        return 0, ""
    return (1, "") if isinstance(value, numbers.Number) else (2, type(value).__name__)


def _comparison(compare: Callable[[Any, Any], Any]) -> Callable[[Any, Any], Any]:
    def compared(a: Any, b: Any) -> Any:
        try:
            return compare(a, b)
        except TypeError:
            if _rank(a) == _rank(b):
                raise
            return compare(_rank(a), _rank(b))
    return compared


py2_less, py2_greater = _comparison(operator.lt), _comparison(operator.gt)
py2_less_equal, py2_greater_equal = _comparison(operator.le), _comparison(operator.ge)


def py2_decode(value: Any, *arguments: Any, **named: Any) -> Any:
    """value.decode(): a text may be its own bytes, of "hex" and the like, or is text already."""
    if not isinstance(value, str):
        return value.decode(*arguments, **named)
    if arguments and _isOfBytes(arguments[0]):
        return codecs.decode(value.encode("latin-1"), arguments[0]).decode("latin-1")
    return value


def py2_encode(value: Any, *arguments: Any, **named: Any) -> Any:
    """value.encode(): "hex" and the like make text of a text's bytes."""
    if arguments and isinstance(value, (str, bytes)) and _isOfBytes(arguments[0]):
        data = value.encode("latin-1") if isinstance(value, str) else value
        return codecs.encode(data, arguments[0]).decode("latin-1")
    return value.encode(*arguments, **named)


def _isOfBytes(encoding: Any) -> bool:
    return str(encoding).replace("_codec", "") in {"hex", "base64", "zlib", "bz2"}


def cmp(a: Any, b: Any) -> int:
    return py2_greater(a, b) - py2_less(a, b)


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
