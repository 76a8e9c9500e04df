"""Writes pictures as PNG files: a signature, then chunks of length, name, data and checksum."""

import struct
import zlib

RGB_8_BIT = struct.pack(">BBBBB", 8, 2, 0, 0, 0)  # depth, colour type, three defaults


def toPng(width: int, height: int, rgb: bytes) -> bytes:
    """The PNG file of a picture of 3 bytes a pixel, rows from the top."""
    if len(rgb) != 3 * width * height:
        raise ValueError("%d bytes are not %d x %d pixels of RGB" % (len(rgb), width, height))
    rows = b"".join(b"\0" + rgb[row:row + 3 * width] for row in range(0, len(rgb), 3 * width))
    return (b"\x89PNG\r\n\x1a\n" +
            _chunk(b"IHDR", struct.pack(">II", width, height) + RGB_8_BIT) +
            _chunk(b"IDAT", zlib.compress(rows, 6)) + _chunk(b"IEND", b""))


def _chunk(name: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
