#!/usr/bin/env python3
"""Moves the head and compares what was asked with what the encoders measure."""

import sys

from naoqi import ALProxy

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 9559

motion = ALProxy("ALMotion", ip, port)
motion.setStiffnesses("Head", 1.0)
motion.angleInterpolation(["HeadYaw", "HeadPitch"],    # rad
                          [[0.6, -0.6, 0.0], [0.2, 0.0]],
                          [[1.0, 2.5, 3.5], [1.0, 3.5]],  # s
                          True)
for name in ("HeadYaw", "HeadPitch"):
    commanded = motion.getAngles(name, False)[0]
    measured = motion.getAngles(name, True)[0]
    print("%-9s commanded %+.3f rad, measured %+.3f rad" % (name, commanded, measured))
