"""Frames: a 28 byte header, then the payload. Bytes in, messages out; no sockets here.

    magic u32 | id u32 | payload size u32 | version u16 | type u8 | flags u8
    | service u32 | object u32 | action u32        (all little-endian)
"""

import struct
from enum import IntEnum
from typing import List, NamedTuple

from .errors import DecodeError

MAGIC = 0x42ADDE42
HEADER = struct.Struct("<IIIHBBIII")
MAX_PAYLOAD = 64 << 20  # bytes; the largest image is 15 MB

FLAG_DYNAMIC = 1  # the payload is one dynamic value
FLAG_RETURN_TYPE = 2  # the arguments are followed by the signature the caller wants back


class Kind(IntEnum):
    CALL = 1
    REPLY = 2
    ERROR = 3
    POST = 4
    EVENT = 5
    CAPABILITY = 6
    CANCEL = 7
    CANCELED = 8


class Message(NamedTuple):
    kind: int
    id: int
    service: int
    object: int
    action: int
    payload: bytes = b""
    flags: int = 0

    def toBytes(self) -> bytes:
        return HEADER.pack(MAGIC, self.id, len(self.payload), 0, self.kind, self.flags,
                           self.service, self.object, self.action) + self.payload


class Splitter:
    """Cuts a stream of bytes into messages; keeps an unfinished one until the rest comes."""

    def __init__(self):
        self._rest = bytearray()

    def feed(self, data: bytes) -> List[Message]:
        """The messages that `data` completes. Raises DecodeError: the stream is lost for good."""
        self._rest += data
        messages = []
        start = 0
        while len(self._rest) - start >= HEADER.size:
            (magic, number, size, version, kind, flags,
             service, obj, action) = HEADER.unpack_from(self._rest, start)
            if magic != MAGIC or version != 0:
                raise DecodeError("the other side does not speak qi messaging")
            if size > MAX_PAYLOAD:
                raise DecodeError("a message of %d bytes is too large" % size)
            end = start + HEADER.size + size
            if end > len(self._rest):
                break
            payload = bytes(memoryview(self._rest)[start + HEADER.size:end])
            messages.append(Message(kind, number, service, obj, action, payload, flags))
            start = end
        del self._rest[:start]
        return messages
