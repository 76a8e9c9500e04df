"""Fits Python values to declared types, and says how well: the client's half of overload choice.

A fit is a number from 0 (impossible) to 1 (exact): the product over a tuple's fields, the worst
of a list's items, so that a long list is not a bad one. The penalties are those that decide between NaoQi's overloads.
"""

import numbers
from typing import Any, Tuple

from .encoding import Reference, Typed, signatureOf
from .errors import ConversionError
from .signature import Type, parse

TO_DYNAMIC = 0.95
FLOAT_TO_INT = 0.97
INT_TO_FLOAT = 0.98
TO_OR_FROM_BOOL = 0.96
OTHER_SHAPE = 0.99  # tuple for list, list for tuple, text for raw

INT_RANGES = {kind: ((-(1 << bits - 1), (1 << bits - 1) - 1) if kind.islower() else
                     (0, (1 << bits) - 1))
              for kinds, bits in (("cC", 8), ("wW", 16), ("iI", 32), ("lL", 64)) for kind in kinds}
FLOAT_MAX = 3.4028234663852886e38

_IMPOSSIBLE = (0.0, None)


def convert(signature: str, value: Any) -> Any:
    """`value` as encoding.encode() wants it for `signature`. Raises ConversionError."""
    score, converted = fit(parse(signature), value)
    if not score:
        raise ConversionError("cannot use %.80r as '%s'" % (value, signature))
    return converted


def fit(node: Type, value: Any) -> Tuple[float, Any]:
    """How well `value` fits, and what it becomes."""
    value = plain(value)
    kind = node.kind
    if kind == "m":
        return _fitDynamic(value)
    if isinstance(value, Typed):
        value = value.value
    if kind == "b":
        return _fitBool(value)
    if kind in INT_RANGES:
        return _fitInt(value, *INT_RANGES[kind])
    if kind in "fd":
        return _fitFloat(value, FLOAT_MAX if kind == "f" else float("inf"))
    if kind in "sr":
        return _fitText(kind, value)
    if kind in "[#":
        return _fitList(node.items[0], value)
    if kind == "(":
        return _fitTuple(node, value)
    if kind == "{":
        return _fitMap(node, value)
    if kind == "+":
        return (1.0, None) if value is None else fit(node.items[0], value)
    if kind == "o":
        return (1.0, value) if isinstance(value, Reference) else _IMPOSSIBLE
    return (1.0, None) if kind in "v_" and value is None else _IMPOSSIBLE


def plain(value: Any) -> Any:
    """Numbers and arrays of other libraries (numpy) as Python's own."""
    if value is None or isinstance(value, (str, bytes, bytearray, list, tuple, dict, int, float)):
        return value
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        return float(value)
    return value.tolist() if hasattr(value, "tolist") else value


def _fitDynamic(value: Any) -> Tuple[float, Any]:
    try:
        value = _plainInside(value)
        if isinstance(value, int) and not _inRange(value, *INT_RANGES["l"]):
            return _IMPOSSIBLE
        signatureOf(value)
    except ConversionError:
        return _IMPOSSIBLE
    return TO_DYNAMIC, value


def _plainInside(value: Any) -> Any:
    value = plain(value)
    if isinstance(value, Typed):
        return value
    if isinstance(value, list):
        return [_plainInside(item) for item in value]
    if isinstance(value, tuple):
        return tuple(_plainInside(item) for item in value)
    if isinstance(value, dict):
        return {_plainInside(key): _plainInside(item) for key, item in value.items()}
    return value


def _inRange(value: float, low: float, high: float) -> bool:
    return low <= value <= high


def _fitBool(value: Any) -> Tuple[float, Any]:
    if isinstance(value, bool):
        return 1.0, value
    if isinstance(value, (int, float)) and value in (0, 1):
        return TO_OR_FROM_BOOL, bool(value)
    return _IMPOSSIBLE


def _fitInt(value: Any, low: int, high: int) -> Tuple[float, Any]:
    if isinstance(value, bool):
        return TO_OR_FROM_BOOL, int(value)
    if isinstance(value, int) and _inRange(value, low, high):
        return 1.0, value
    if isinstance(value, float) and _inRange(value, low, high):
        return FLOAT_TO_INT, int(value)
    return _IMPOSSIBLE


def _fitFloat(value: Any, limit: float) -> Tuple[float, Any]:
    if isinstance(value, bool):
        return TO_OR_FROM_BOOL * INT_TO_FLOAT, float(value)
    if isinstance(value, int):
        return (INT_TO_FLOAT, float(value)) if abs(value) <= min(limit, 1e308) else _IMPOSSIBLE
    if isinstance(value, float):
        finite = value == value and abs(value) != float("inf")
        return (1.0, value) if abs(value) <= limit or not finite else _IMPOSSIBLE
    return _IMPOSSIBLE


def _fitText(kind: str, value: Any) -> Tuple[float, Any]:
    if isinstance(value, str):
        return (1.0 if kind == "s" else OTHER_SHAPE), value
    if isinstance(value, (bytes, bytearray, memoryview)):
        return (1.0 if kind == "r" else OTHER_SHAPE), value
    return _IMPOSSIBLE


def _fitList(item: Type, value: Any) -> Tuple[float, Any]:
    if not isinstance(value, (list, tuple)):
        return _IMPOSSIBLE
    score, items = _fitAll([item] * len(value), value)
    return score * (1.0 if isinstance(value, list) else OTHER_SHAPE), items


def _fitTuple(node: Type, value: Any) -> Tuple[float, Any]:
    if isinstance(value, dict) and node.fields and set(value) == set(node.fields):
        value = tuple(value[field] for field in node.fields)
    if not isinstance(value, (list, tuple)) or len(value) != len(node.items):
        return _IMPOSSIBLE
    score, items = 1.0 if isinstance(value, tuple) else OTHER_SHAPE, []
    for item, part in zip(node.items, value):
        part_score, converted = fit(item, part)
        score *= part_score
        items.append(converted)
    return score, tuple(items)


def _fitMap(node: Type, value: Any) -> Tuple[float, Any]:
    if not isinstance(value, dict):
        return _IMPOSSIBLE
    key_score, keys = _fitAll([node.items[0]] * len(value), list(value.keys()))
    score, parts = _fitAll([node.items[1]] * len(value), list(value.values()))
    return key_score * score, dict(zip(keys or (), parts or ()))


def _fitAll(nodes: Any, values: Any) -> Tuple[float, Any]:
    worst, converted = 1.0, []
    for node, value in zip(nodes, values):
        score, part = fit(node, value)
        if not score:
            return _IMPOSSIBLE
        worst = min(worst, score)
        converted.append(part)
    return worst, converted
