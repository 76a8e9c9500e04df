"""Wakes the robot up and goes to a posture: stand.py [StandInit]"""

import sys

from naoqi import ALProxy

posture = sys.argv[1] if len(sys.argv) > 1 else "StandInit"
ALProxy("ALMotion").wakeUp()
if not ALProxy("ALRobotPosture").goToPosture(posture, 0.8):
    sys.exit("the posture was not reached")
