"""Python values to bytes. Values must already be of their type: see conversion.py.

A dynamic (m) travels as its signature and its value; the signature comes from the Python value:
bool b, int l, float d, str and bytes s, None v, list [m], tuple (m...), dict {mm}. `Typed` says
otherwise.
"""

import struct
from typing import Any, NamedTuple

from .errors import ConversionError
from .signature import Type, parse

FORMATS = {"b": "?", "c": "b", "C": "B", "w": "h", "W": "H", "i": "i", "I": "I", "l": "q",
           "L": "Q", "f": "f", "d": "d"}
_STRUCTS = {kind: struct.Struct("<" + form) for kind, form in FORMATS.items()}
_U32 = struct.Struct("<I")


class Typed(NamedTuple):
    """A value that travels in a dynamic with this signature rather than its natural one."""

    signature: str
    value: Any


class Reference:
    """An object hosted at this end, ready to travel: its metaobject, numbers and uid as bytes."""

    def __init__(self, data: bytes):
        self.data = data


def encode(signature: str, value: Any) -> bytes:
    """The bytes of `value` as `signature`. Raises ConversionError if they do not match."""
    out = bytearray()
    try:
        _put(out, parse(signature), value)
    except (struct.error, TypeError, AttributeError, ValueError, OverflowError,
            RecursionError) as error:
        raise ConversionError("cannot send %.80r as '%s': %s" % (value, signature, error)) from None
    return bytes(out)


def signatureOf(value: Any) -> str:
    """The signature with which `value` travels in a dynamic."""
    if isinstance(value, Typed):
        return value.signature
    if isinstance(value, Reference):
        return "o"
    if isinstance(value, tuple):
        return "(" + "m" * len(value) + ")"
    for python_type, signature in ((bool, "b"), (int, "l"), (float, "d"), (str, "s"),
                                   ((bytes, bytearray, memoryview), "s"), (type(None), "v"),
                                   (list, "[m]"), (dict, "{mm}")):
        if isinstance(value, python_type):
            return signature
    raise ConversionError("values of type %s have no form on the wire" % type(value).__name__)


def _put(out: bytearray, node: Type, value: Any) -> None:
    kind = node.kind
    if kind in _STRUCTS:
        out += _STRUCTS[kind].pack(value)
    elif kind in "sr":
        _putBytes(out, value)
    elif kind in "[#":
        _putList(out, node.items[0], value)
    elif kind == "{":
        _putMap(out, node, value)
    elif kind == "(":
        if len(value) != len(node.items):
            raise ValueError("%d values for %d fields" % (len(value), len(node.items)))
        for item, part in zip(node.items, value):
            _put(out, item, part)
    elif kind == "m":
        _putDynamic(out, value)
    elif kind == "o":
        out += value.data
    elif kind == "+":
        out.append(value is not None)
        if value is not None:
            _put(out, node.items[0], value)
    elif kind not in "v_":
        raise TypeError("type '%s' cannot be sent" % kind)


def _putBytes(out: bytearray, value: Any) -> None:
    data = value.encode("utf-8", "surrogateescape") if isinstance(value, str) else bytes(value)
    out += _U32.pack(len(data))
    out += data


def _putList(out: bytearray, item: Type, values: Any) -> None:
    out += _U32.pack(len(values))
    if item.kind in FORMATS:
        out += struct.pack("<%d%s" % (len(values), FORMATS[item.kind]), *values)
        return
    for value in values:
        _put(out, item, value)


def _putMap(out: bytearray, node: Type, value: dict) -> None:
    out += _U32.pack(len(value))
    pairs = value.items()
    if all(isinstance(key, (str, int)) for key in value) and len(set(map(type, value))) < 2:
        pairs = sorted(pairs)  # real clients send keys in order
    for key, part in pairs:
        _put(out, node.items[0], key)
        _put(out, node.items[1], part)


def _putDynamic(out: bytearray, value: Any) -> None:
    signature = signatureOf(value)
    _putBytes(out, signature)
    _put(out, parse(signature), value.value if isinstance(value, Typed) else value)
