"""Turns the head: head.py yaw pitch [rad]. Fails if its encoders do not follow within 2 s."""

import sys
import time

from naoqi import ALProxy

target = [float(angle) for angle in sys.argv[1:3]]
motion = ALProxy("ALMotion")
motion.setStiffnesses("Head", 1.0)
motion.setAngles("Head", target, 0.2)
for _ in range(20):
    time.sleep(0.1)
    angles = motion.getAngles("Head", True)
    if all(abs(angle - wanted) < 0.05 for angle, wanted in zip(angles, target)):
        sys.exit(0)
sys.exit(3)
