"""A LoLA program that answers 40 frames: lola_ends.py SOCKET HOW, and ends as it is told."""

import os
import signal
import socket
import struct
import sys
import time

FRAME = 896


def receive(robot):
    frame = b""
    while len(frame) < FRAME:
        frame += robot.recv(FRAME - len(frame)) or sys.exit("the robot closed the connection")


def packed(name, numbers):
    """A MessagePack map of one list of float32."""
    head = b"\x81" + bytes([0xA0 | len(name)]) + name.encode() + b"\xdc"
    return (head + struct.pack(">H", len(numbers))
            + b"".join(b"\xca" + struct.pack(">f", number) for number in numbers))


robot = socket.socket(socket.AF_UNIX)
robot.connect(sys.argv[1])
for k in range(40):
    receive(robot)
    robot.sendall(packed("Stiffness", [k / 40.0] * 25))
if sys.argv[2] == "exit":
    os._exit(0)
if sys.argv[2] == "kill":
    os.kill(os.getpid(), signal.SIGKILL)
receive(robot)  # "late": its answer has been followed by a frame, and the world waits
time.sleep(0.05)
