"""What words and operators meant in Python 2, for converted programs."""

import builtins
import decimal
import importlib
import itertools
import math
import numbers
import operator
import sys
from collections import namedtuple
from functools import cmp_to_key
from typing import Any, Callable, List, Optional, Tuple

from . import loader
from .byte_text import (py2_bytearray, py2_bytes, py2_call, py2_chr, py2_decode, py2_encode,
                        py2_join, py2_pickle, py2_process)

__all__ = ["bytearray", "chr", "cmp", "exec", "execfile", "file", "filter", "map", "open",
           "ord", "py2_bytes", "py2_call", "py2_chain", "py2_decode", "py2_divide", "py2_encode",
           "py2_greater", "py2_greater_equal", "py2_items", "py2_join", "py2_less", "py2_less_equal",
           "py2_message", "py2_next", "py2_pickle", "py2_process", "py2_sort", "py2_translate",
           "py2_version_info", "raw_input", "reload", "round", "sorted", "unichr", "zip"]

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


def cmp(a: Any, b: Any) -> int:
    return py2_greater(a, b) - py2_less(a, b)


_compare = cmp
COMPARISONS = {"<": py2_less, ">": py2_greater, "<=": py2_less_equal, ">=": py2_greater_equal,
               "==": operator.eq, "!=": operator.ne}


def py2_chain(left: Any, *rest: Any) -> Any:
    """left < a() < b(): signs and functions in turn."""
    result = True
    for sign, right in builtins.zip(rest[::2], rest[1::2]):
        value = right()
        result = COMPARISONS[sign](left, value)
        if not result:
            break
        left = value
    return result


def ord(character: Any) -> int:  # pylint: disable=redefined-builtin
    """Of a byte, too, which is a number already in Python 3."""
    return character if isinstance(character, int) else builtins.ord(character)


def sorted(values: Any,  # pylint: disable=redefined-builtin
           cmp: Optional[Callable[[Any, Any], int]] = None, key: Any = None,
           reverse: bool = False) -> List[Any]:
    """Also of things that Python 3 does not compare."""
    values = list(values)
    if cmp:
        order = cmp_to_key(cmp)
        return builtins.sorted(values, key=lambda v: order(key(v) if key else v), reverse=reverse)
    try:
        return builtins.sorted(values, key=key, reverse=reverse)
    except TypeError:
        return sorted(values, _compare, key, reverse)


def py2_sort(values: Any, *arguments: Any, **named: Any) -> Any:
    """values.sort()"""
    if not isinstance(values, list):
        return values.sort(*arguments, **named)
    values[:] = sorted(values, *arguments, **named)
    return None


def py2_next(values: Any, *arguments: Any) -> Any:
    """values.next()"""
    if hasattr(values, "next") or arguments:
        return values.next(*arguments)
    return next(values)


def py2_translate(text: Any, *arguments: Any) -> Any:
    """text.translate(table, characters to leave out): without a table nothing else changes."""
    if not isinstance(text, str):
        return text.translate(*arguments)
    table, left_out = (list(arguments) + [""])[:2]
    kept = "".join(letter for letter in text if letter not in left_out)
    return kept if table is None else kept.translate(table)


def py2_message(error: Any) -> Any:
    """error.message"""
    if not isinstance(error, BaseException) or hasattr(error, "message"):
        return error.message
    return error.args[0] if len(error.args) == 1 else ""


def py2_items(error: Any) -> Any:
    """What error[0] is taken from."""
    plain = isinstance(error, BaseException) and not hasattr(error, "__getitem__")
    return error.args if plain else error


def map(function: Any, *lists: Any) -> List[Any]:  # pylint: disable=redefined-builtin
    """The shorter ones are filled up with None; so may the function be."""
    if len(lists) == 1:
        return [function(one) for one in lists[0]] if function else list(lists[0])
    rows = itertools.zip_longest(*lists)
    return [function(*row) if function else row for row in rows]


def filter(function: Any, values: Any) -> Any:  # pylint: disable=redefined-builtin
    """Of a text a text, of a tuple a tuple."""
    kept = builtins.filter(function, values)
    if isinstance(values, str):
        return "".join(kept)
    return tuple(kept) if isinstance(values, tuple) else list(kept)


def zip(*lists: Any) -> List[Any]:  # pylint: disable=redefined-builtin
    return list(builtins.zip(*lists))


def round(number: Any, digits: int = 0) -> float:  # pylint: disable=redefined-builtin
    """A float; halves away from zero."""
    value = float(number)
    if not math.isfinite(value):
        return value
    wide = decimal.Context(prec=1100, rounding=decimal.ROUND_HALF_UP)
    return float(decimal.Decimal(value).quantize(decimal.Decimal(1).scaleb(-digits), context=wide))


def open(name: Any, mode: str = "r",  # pylint: disable=redefined-builtin
         buffering: int = -1) -> Any:
    """Bytes that are no text pass through a text file as they are; a table is text."""
    mode = mode.replace("U", "") or "r"
    if str(name).endswith(".csv"):
        mode = mode.replace("b", "")
    if "b" in mode:
        return builtins.open(name, mode, buffering)
    return builtins.open(name, mode, 1 if buffering == 0 else buffering, encoding="utf-8",
                         errors="surrogateescape")


file = open


def execfile(path: str, names: Any = None, own: Any = None) -> None:
    """In the caller's names unless told others."""
    _run(loader.current().compiled(path), names, own, sys._getframe(1))


def exec(code: Any, names: Any = None,  # pylint: disable=redefined-builtin
         own: Any = None) -> None:
    """The same, of a text or what compile() made of one."""
    if isinstance(code, (str, bytes)):
        code = loader.current().translator.toPython3(str(code), "<string>")
    _run(code, names, own, sys._getframe(1))


def _run(code: Any, names: Any, own: Any, caller: Any) -> None:
    if names is None:
        names, own = caller.f_globals, caller.f_locals
    builtins.exec(code, names, names if own is None else own)


def reload(module: Any) -> Any:
    """`reload(sys)` was the way to setdefaultencoding()."""
    if module is not sys:
        return importlib.reload(module)
    sys.setdefaultencoding = lambda _: None  # type: ignore[attr-defined]
    return module


unichr, chr = builtins.chr, py2_chr  # pylint: disable=redefined-builtin
raw_input, bytearray = input, py2_bytearray  # pylint: disable=redefined-builtin
