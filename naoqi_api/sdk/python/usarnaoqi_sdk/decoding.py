"""Bytes to Python values. Whatever the bytes, the worst that happens is a DecodeError.

Dynamics become the value they hold, tuples and structs become tuples, strings that are not UTF-8
keep their bytes (surrogateescape), raw buffers become bytes.
"""

import struct
from typing import Any, Callable, Optional

from .encoding import FORMATS
from .errors import DecodeError
from .signature import MAX_DEPTH, Type, parse

_U32 = struct.Struct("<I")
_STRUCTS = {kind: struct.Struct("<" + form) for kind, form in FORMATS.items()}
MAX_EMPTY_ITEMS = 1 << 16  # items that take no bytes: their number is not bounded by the payload

# Reads an object reference ("o") from the reader; only a connection knows how.
ObjectReader = Callable[["Reader"], Any]


def decode(signature: str, data: bytes, read_object: Optional[ObjectReader] = None) -> Any:
    """The value of `data`, which must hold exactly one `signature`."""
    reader = Reader(data, read_object)
    value = reader.value(parse(signature))
    if reader.at != len(data):
        raise DecodeError("%d bytes too many for '%s'" % (len(data) - reader.at, signature))
    return value


class Reader:
    """A position in a payload."""

    def __init__(self, data: bytes, read_object: Optional[ObjectReader] = None):
        self.data = data
        self.at = 0
        self._read_object = read_object
        self._depth = 0

    def value(self, node: Type) -> Any:
        self._depth += 1
        if self._depth > 2 * MAX_DEPTH:
            raise DecodeError("values nest too deeply")
        try:
            return self._value(node)
        finally:
            self._depth -= 1

    def bytes(self, count: int) -> bytes:
        if count > len(self.data) - self.at:
            raise DecodeError("the payload ends early")
        self.at += count
        return self.data[self.at - count:self.at]

    def u32(self) -> int:
        return _U32.unpack(self.bytes(4))[0]

    def string(self) -> str:
        return self.bytes(self.u32()).decode("utf-8", "surrogateescape")

    def _value(self, node: Type) -> Any:
        kind = node.kind
        if kind in _STRUCTS:
            return _STRUCTS[kind].unpack(self.bytes(_STRUCTS[kind].size))[0]
        if kind == "s":
            return self.string()
        if kind == "m":
            signature = self.string()
            return self.value(parse(signature)) if signature else None
        if kind in "[#":
            return self._list(node.items[0])
        if kind == "{":
            return self._map(node)
        if kind == "(":
            return tuple([self.value(item) for item in node.items])
        if kind == "r":
            return self.bytes(self.u32())
        if kind == "+":
            return self.value(node.items[0]) if self.bytes(1) != b"\0" else None
        if kind == "o" and self._read_object:
            return self._read_object(self)
        if kind in "v_":
            return None
        raise DecodeError("type '%s' cannot be received" % kind)

    def _count(self, *items: Type) -> int:
        count = self.u32()
        takes_bytes = any(_takesBytes(item) for item in items)
        if count > (len(self.data) - self.at if takes_bytes else MAX_EMPTY_ITEMS):
            raise DecodeError("the payload ends early")
        return count

    def _list(self, item: Type) -> list:
        count = self._count(item)
        if item.kind in FORMATS:
            form = "<%d%s" % (count, FORMATS[item.kind])
            return list(struct.unpack(form, self.bytes(struct.calcsize(form))))
        return [self.value(item) for _ in range(count)]

    def _map(self, node: Type) -> dict:
        key, part = node.items
        try:
            return {self.value(key): self.value(part) for _ in range(self._count(key, part))}
        except TypeError:
            raise DecodeError("a map's key is a list or a map") from None


def _takesBytes(node: Type) -> bool:
    if node.kind == "(":
        return any(_takesBytes(item) for item in node.items)
    return node.kind not in "v_"
