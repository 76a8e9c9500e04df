"""Writes the first inputs of the fuzz targets, mostly from captured sessions: make_corpus.py DIR"""
import pathlib
import struct
import sys

CAPTURES = pathlib.Path(__file__).parents[1] / "data" / "captures"
HEADER = 28
CALLS = {"say": ["js"], "add": [1, 2], "echo": [[1, 0.5, True, None]], "tick": ["connect"],
         "level": ["setValue", 0.75], "helper": []}


def messages(capture):
    """What the client of a captured session sent, message by message."""
    lines = capture.read_text().splitlines()
    return [bytes.fromhex(line.split(" ")[1]) for line in lines if line[1:2] == ">" or line[:1] == ">"]


def dynamics(payload):
    """Everything in a payload that looks like a dynamic: a short signature and what follows."""
    for at in range(len(payload) - 4):
        size = struct.unpack_from("<I", payload, at)[0]
        text = payload[at + 4:at + 4 + size]
        if 0 < size <= 64 and len(text) == size and all(c in b"bcCwWiIlLfdsrmov[]{}()+" for c in text):
            yield payload[at:]


def pack(value):
    """MessagePack, as far as the first inputs need it."""
    if value is None or isinstance(value, bool):
        return {None: b"\xc0", False: b"\xc2", True: b"\xc3"}[value]
    if isinstance(value, int):
        return bytes([value])
    if isinstance(value, float):
        return b"\xcb" + struct.pack(">d", value)
    if isinstance(value, str):
        return bytes([0xa0 + len(value)]) + value.encode()
    return bytes([0x90 + len(value)]) + b"".join(map(pack, value))


def inputs():
    """(target, bytes) of every first input."""
    for capture in sorted(CAPTURES.glob("*.txt")):
        sent = messages(capture)
        for start in range(0, len(sent), 8):
            yield "frames", b"\x00\xff" + b"".join(sent[:1] + sent[start:start + 8])
        for message in sent:
            for dynamic in dynamics(message[HEADER:]):
                yield "value", dynamic
                size = struct.unpack_from("<I", dynamic)[0]
                yield "signature", dynamic[4:4 + size]
    service = '5:::{"name":"call","args":[{"idm":1,"params":{"obj":"ServiceDirectory",' \
              '"member":"service","args":["Demo"]}}]}'
    for member, arguments in CALLS.items():
        text = str(arguments).replace("'", '"').replace("True", "true").replace("None", "null")
        call = '5:::{"name":"call","args":[{"idm":2,"params":{"obj":0,"member":"%s","args":%s}}]}'
        yield "json", (service + "\n" + call % (member, text)).encode()
        yield "msgpack", b"\xff" + pack([0, 1, "Demo." + member, arguments])
    for method, argument in (("subscribe", "Demo.tick"), ("property", "Demo.level"),
                             ("methods", "Demo"), ("release", "#0")):
        yield "msgpack", b"\xff" + pack([0, 2, method, [argument]]) + pack([2, "Demo.fire", [7]])


def main(folder):
    for number, (target, data) in enumerate(inputs()):
        place = pathlib.Path(folder) / target
        place.mkdir(parents=True, exist_ok=True)
        (place / ("capture_%04d" % number)).write_bytes(data)


main(sys.argv[1])
