"""Stands until the robot has fallen, and gets up again."""

import sys
import time

from naoqi import ALProxy

memory = ALProxy("ALMemory")
posture = ALProxy("ALRobotPosture")
ALProxy("ALMotion").wakeUp()
posture.goToPosture("StandInit", 0.8)
until = time.time() + 10
while not memory.getData("robotHasFallen"):
    if time.time() > until:
        sys.exit("nobody pushed it over")
    time.sleep(0.05)
time.sleep(2)
ALProxy("ALMotion").wakeUp()
if not posture.goToPosture("StandInit", 0.6):
    sys.exit("it did not get up")
