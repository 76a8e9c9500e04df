#!/usr/bin/env python3
"""Takes a picture as programs beside LoLA do, and saves its brightness as lola_camera.pgm:
usarnaoqi serve --lola --lola-camera-port"""

import socket
import struct
import sys

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 10001  # the top camera's; the bottom one's is next

HEADER = struct.Struct("<8sHBBHH")  # magic, tick of 12 ms, camera, bytes per pixel, width, height

with socket.create_connection((ip, port)) as camera, camera.makefile("rb") as stream:
    magic, tick, number, depth, width, height = HEADER.unpack(stream.read(HEADER.size))
    if magic != b"wbimage\0":
        sys.exit("port %d is no camera's" % port)
    pixels = stream.read(width * height * depth)  # rows of Y U Y V, from the top

with open("lola_camera.pgm", "wb") as file:
    file.write(b"P5 %d %d 255\n" % (width, height) + pixels[::2])
print("lola_camera.pgm: %d x %d by camera %d, tick %d" % (width, height, number, tick))
