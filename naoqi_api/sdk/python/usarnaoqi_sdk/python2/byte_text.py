"""Python 2's str was text and bytes alike. Converted programs get text for bytes that are plain
text, else bytes that mix with text; and they may hand text to who wants bytes."""

import codecs
import struct
from typing import Any, Iterator

OF_BYTES = frozenset({"hex", "base64", "zlib", "bz2"})  # encodings from bytes to bytes
RARE = frozenset("\xfe\xff")  # letters that are more often bytes
TEXTS = frozenset({"", "ascii", "us-ascii", "utf8", "utf_8", "utf-8"})


def toBytes(text: str) -> bytes:
    """Of a text with letters as UTF-8; one whose characters are bytes already, as "\\xff\\x00"."""
    if text.isascii():
        return text.encode()
    try:
        plain = text.encode("latin-1")
    except UnicodeEncodeError:
        return text.encode("utf-8", "surrogateescape")
    is_text = "".join(text.split()).isprintable() and not set(text) & RARE and not _isUtf8(plain)
    return text.encode() if is_text else plain


def toText(data: bytes) -> str:
    return bytes.decode(data, "utf-8" if _isUtf8(data) else "latin-1")


def _isUtf8(data: bytes) -> bool:
    try:
        bytes.decode(data, "utf-8")
        return True
    except UnicodeDecodeError:
        return False


def _asBytes(value: Any) -> Any:
    return toBytes(value) if isinstance(value, str) else value


def wrapped(value: Any) -> Any:
    """Text or bytes that mix with it in place of plain bytes, in lists and tuples, too."""
    if type(value) is bytes:
        is_text = value.isascii() and b"".join(value.split()).decode().isprintable()
        return value.decode() if is_text else Bytes(value)
    if type(value) in (list, tuple) and any(type(part) is bytes for part in value):
        return type(value)(wrapped(part) for part in value)
    return value


class Bytes(bytes):
    """Bytes that are text where they meet text; their parts are such, too."""

    def __str__(self):
        return toText(self)

    def __repr__(self):
        return bytes.__repr__(self)[1:]

    def __format__(self, how):
        return format(toText(self), how)

    def __eq__(self, other):
        same = bytes.__eq__(self, _asBytes(other))
        return same if same is True else bytes.__eq__(self, _ownBytes(other))

    def __ne__(self, other):
        return not self == other

    __hash__ = bytes.__hash__  # that of the same text, if it is ASCII

    def __add__(self, other):
        if isinstance(other, str) and _isUtf8(self):
            return toText(self) + other
        return Bytes(bytes.__add__(self, _asBytes(other)))

    def __radd__(self, other):
        if isinstance(other, str) and _isUtf8(self):
            return other + toText(self)
        return Bytes(bytes.__add__(_asBytes(other), self))

    def __mul__(self, count):
        return Bytes(bytes.__mul__(self, count))

    __rmul__ = __mul__

    def __mod__(self, values):
        return toText(self) % values

    def __contains__(self, part):
        return bytes.__contains__(self, _asBytes(part))

    def __getitem__(self, at):
        if not isinstance(at, slice):
            at = slice(at, at + 1 or None)
            if not bytes.__getitem__(self, at):
                raise IndexError("string index out of range")
        return Bytes(bytes.__getitem__(self, at))

    def __iter__(self):
        return (self[at] for at in range(len(self)))

    def join(self, parts):
        return py2_join(toText(self), parts)

    def format(self, *arguments, **named):
        return toText(self).format(*arguments, **named)


def _mixing(name: str) -> Any:
    def method(self: Bytes, *arguments: Any) -> Any:
        return wrapped(getattr(bytes, name)(self, *[_asBytes(one) for one in arguments]))

    method.__name__ = name
    return method


for _name in ("capitalize", "center", "count", "endswith", "expandtabs", "find", "index", "ljust",
              "lower", "lstrip", "partition", "replace", "rfind", "rindex", "rjust", "rpartition",
              "rsplit", "rstrip", "split", "splitlines", "startswith", "strip", "swapcase", "title",
              "upper", "zfill"):
    setattr(Bytes, _name, _mixing(_name))


def py2_bytes(data: bytes) -> Bytes:
    """b"..." """
    return Bytes(data)


def py2_chr(number: int) -> Any:
    """chr(): a byte, a letter if it is ASCII."""
    return chr(number) if 0 <= number < 128 else Bytes(bytes([number]))


class py2_bytearray(bytearray):  # pylint: disable=invalid-name
    """Made of text, too, and written as one."""

    def __init__(self, value: Any = b"", *rest: Any):
        bytearray.__init__(self, _asBytes(value) if not rest else value, *rest)

    def __str__(self):
        return toText(bytes(self))


def py2_decode(value: Any, *arguments: Any, **named: Any) -> Any:
    """value.decode(): a text may be its own bytes, of "hex" and the like, or is text already."""
    encoding = _encoding(arguments)
    if encoding in OF_BYTES and isinstance(value, (str, bytes)):
        return wrapped(codecs.decode(_asBytes(value), encoding))
    if not isinstance(value, str):
        return value.decode(*arguments, **named)
    if encoding in TEXTS and not value.isascii():
        return toText(toBytes(value))
    return value


def py2_encode(value: Any, *arguments: Any, **named: Any) -> Any:
    """value.encode(): what is UTF-8 or ASCII stays text; "hex" and the like make text."""
    encoding = _encoding(arguments)
    if encoding in OF_BYTES and isinstance(value, (str, bytes)):
        return toText(codecs.encode(_ownBytes(value), encoding))
    if isinstance(value, bytes):
        return wrapped(value)
    encoded = value.encode(*arguments, **named)
    if encoding in TEXTS and isinstance(value, str):
        return encoded.decode("utf-8", "surrogateescape")
    return wrapped(encoded)


def _encoding(arguments: tuple) -> str:
    return str(arguments[0]).lower().replace("_codec", "") if arguments else ""


def _ownBytes(value: Any) -> bytes:
    """Those that its characters are."""
    try:
        return value.encode("latin-1") if isinstance(value, str) else value
    except UnicodeEncodeError:
        return toBytes(value)


def py2_join(value: Any, *arguments: Any, **named: Any) -> Any:
    """value.join(): of a text, bytes may be among what it joins."""
    if not isinstance(value, str):
        return value.join(*arguments, **named)
    parts = list(arguments[0])
    if not any(isinstance(part, bytes) for part in parts):
        return value.join(parts)
    if all(_isUtf8(part) for part in parts if isinstance(part, bytes)):
        return value.join([toText(part) if isinstance(part, bytes) else part for part in parts])
    return Bytes(toBytes(value).join([_asBytes(part) for part in parts]))


def py2_call(value: Any, name: str, *arguments: Any, **named: Any) -> Any:
    """value.name(): of a library that wants bytes where the program has text, or text where it has
    bytes. What goes wrong in the program itself is left as it is."""
    method = getattr(value, name)
    try:
        return wrapped(method(*arguments, **named))
    except (TypeError, struct.error) as error:
        if _isOfTheProgram(error):
            raise
        first = error
    for other in _alternatives(arguments):
        try:
            return wrapped(method(*other, **named))
        except (TypeError, struct.error):
            continue
    raise first


def _alternatives(arguments: tuple) -> Iterator[list]:
    """With the last text or bytes exchanged, then with all."""
    texts = [at for at, one in enumerate(arguments) if isinstance(one, (str, bytes))]
    for chosen in (texts[-1:], texts) if len(texts) > 1 else (texts,) if texts else ():
        yield [_swapped(one) if at in chosen else one for at, one in enumerate(arguments)]


def py2_process(value: Any, name: str, *arguments: Any, **named: Any) -> Any:
    """subprocess.Popen() and its like: what programs tell and are told is text."""
    if getattr(value, "__name__", "") == "subprocess":
        named = {"universal_newlines": True, "errors": "surrogateescape", **named}
    return getattr(value, name)(*arguments, **named)


def py2_pickle(value: Any, name: str, *arguments: Any, **named: Any) -> Any:
    """value.dump() and value.load(): pickle's files could be text files."""
    if getattr(value, "__name__", "") != "pickle":
        return getattr(value, name)(*arguments, **named)
    inner = [getattr(one, "buffer", one) for one in arguments]  # the outer ones close them
    return getattr(value, name)(*inner, **named)


def _swapped(value: Any) -> Any:
    return toBytes(value) if isinstance(value, str) else toText(value)


def _isOfTheProgram(error: Exception) -> bool:
    """Whether converted code was under way: it has this module's names."""
    place = error.__traceback__.tb_next if error.__traceback__ else None
    while place:
        if "py2_call" in place.tb_frame.f_globals:
            return True
        place = place.tb_next
    return False
