"""Walks ahead until a bumper is pressed, at most 20 s, then stops."""

import time

from naoqi import ALProxy

BUMPERS = ["Device/SubDeviceList/%sFoot/Bumper/%s/Sensor/Value" % (foot, side)
           for foot in "LR" for side in ("Left", "Right")]

memory = ALProxy("ALMemory")
motion = ALProxy("ALMotion")
motion.wakeUp()
ALProxy("ALRobotPosture").goToPosture("StandInit", 0.8)
motion.moveToward(0.8, 0, 0)
until = time.time() + 20
while time.time() < until and not any(memory.getListData(BUMPERS)):
    time.sleep(0.02)
motion.stopMove()
