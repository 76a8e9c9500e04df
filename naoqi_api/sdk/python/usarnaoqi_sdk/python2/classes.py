"""Classes of converted programs: what Python 2 called of them goes by other names now."""

import builtins
from typing import Any, Callable

MARK = "py2_call"  # a global of every converted module
NAMES = {"__div__": "__truediv__", "__rdiv__": "__rtruediv__", "__idiv__": "__itruediv__",
         "__unicode__": "__str__"}
COMPARISONS = {"__lt__": lambda sign: sign < 0, "__le__": lambda sign: sign <= 0,
               "__gt__": lambda sign: sign > 0, "__ge__": lambda sign: sign >= 0,
               "__eq__": lambda sign: sign == 0, "__ne__": lambda sign: sign != 0}

_build = builtins.__build_class__


def install() -> None:
    builtins.__build_class__ = _completed  # type: ignore[assignment]


def _completed(body: Any, *arguments: Any, **named: Any) -> Any:
    made = _build(body, *arguments, **named)
    if isinstance(made, type) and MARK in body.__globals__:
        _rename(made)
        _compare(made)
        if "write" in vars(made) and not hasattr(made, "flush"):
            made.flush = lambda self: None  # type: ignore[attr-defined]  # sys.stdout needs one
    return made


def _rename(made: type) -> None:
    own = vars(made)
    for old, new in NAMES.items():
        if old in own and new not in own:
            setattr(made, new, own[old])


def _compare(made: type) -> None:
    """By its __cmp__, if it has one; __eq__ alone does not take its hash."""
    own = vars(made)
    if "__eq__" in own and own.get("__hash__", made) is None:
        made.__hash__ = next(vars(base)["__hash__"]  # type: ignore[method-assign]
                             for base in made.__mro__[1:] if vars(base).get("__hash__"))
    for name, judge in COMPARISONS.items() if "__cmp__" in own else ():
        if name not in own:
            setattr(made, name, _comparison(judge))


def _comparison(judge: Callable[[int], bool]) -> Callable[[Any, Any], bool]:
    return lambda self, other: judge(self.__cmp__(other))
