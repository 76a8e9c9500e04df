#!/usr/bin/env python3
"""Plays a motion file made with Choregraphe, examples/motions/hello.xar unless another is named:
its timeline becomes a behavior of the robot."""

import os
import sys

from naoqi import ALProxy

HELLO = os.path.join(os.path.dirname(os.path.abspath(__file__)), "motions", "hello.xar")
file = sys.argv[1] if len(sys.argv) > 1 else HELLO
ip = sys.argv[2] if len(sys.argv) > 2 else "127.0.0.1"
port = int(sys.argv[3]) if len(sys.argv) > 3 else 9559

ALProxy("ALMotion", ip, port).wakeUp()
ALProxy("ALRobotPosture", ip, port).goToPosture("StandInit", 0.8)
frames = ALProxy("ALFrameManager", ip, port)
with open(file, encoding="utf-8") as content:
    behavior = frames.newBehavior("hello", content.read())
print("plays for %.1f s" % frames.getMotionLength(behavior))
frames.completeBehavior(behavior)  # returns at its end
frames.deleteBehavior(behavior)
