"""Type signatures: text such as "([s]mf)" to a tree.

    type  = atom | "[" type "]" | "{" type type "}" | "(" type* ")" | "#" type | "~" type | "+" type
    atom  = one of b c C w W i I l L f d s r m o v _ X *
    Any type may be followed by "<Name,field,...>", whose angle brackets balance.
"""

from functools import lru_cache
from typing import NamedTuple, Tuple

from .errors import DecodeError

ATOMS = frozenset("bcCwWiIlLfdsrmov_X*")
MAX_DEPTH = 60  # deeper than any known type; keeps garbage from exhausting the stack


class Type(NamedTuple):
    """One node: `kind` is the signature's letter or opening bracket."""

    kind: str
    items: Tuple["Type", ...] = ()
    name: str = ""
    fields: Tuple[str, ...] = ()


@lru_cache(maxsize=4096)
def parse(text: str) -> Type:
    """The type that `text` describes. Raises DecodeError unless it is exactly one type."""
    node, end = _parse_type(text, 0, 0)
    if end != len(text):
        raise DecodeError("signature '%s': unexpected '%s'" % (text, text[end:]))
    return node


def _parse_type(text: str, at: int, depth: int) -> Tuple[Type, int]:
    if at >= len(text) or depth > MAX_DEPTH:
        raise DecodeError("signature '%s' ends early or nests too deeply" % text)
    kind = text[at]
    items: Tuple[Type, ...] = ()
    at += 1
    if kind in "[{(":
        items, at = _parse_items(text, at, {"[": "]", "{": "}", "(": ")"}[kind], depth)
        if len(items) != {"[": 1, "{": 2}.get(kind, len(items)):
            raise DecodeError("signature '%s': wrong number of types within '%s'" % (text, kind))
    elif kind in "#~+":
        item, at = _parse_type(text, at, depth + 1)
        items = (item,)
    elif kind not in ATOMS:
        raise DecodeError("signature '%s': unknown type '%s'" % (text, kind))
    name, fields, at = _parse_annotation(text, at)
    return Type(kind, items, name, fields), at


def _parse_items(text: str, at: int, closing: str, depth: int):
    items = []
    while at < len(text) and text[at] != closing:
        item, at = _parse_type(text, at, depth + 1)
        items.append(item)
    if at >= len(text):
        raise DecodeError("signature '%s': '%s' is missing" % (text, closing))
    return tuple(items), at + 1


def _parse_annotation(text: str, at: int):
    if at >= len(text) or text[at] != "<":
        return "", (), at
    depth, end = 0, at
    while end < len(text):
        depth += {"<": 1, ">": -1}.get(text[end], 0)
        end += 1
        if depth == 0:
            name, *fields = text[at + 1:end - 1].split(",")
            return name, tuple(fields), end
    raise DecodeError("signature '%s': '>' is missing" % text)
