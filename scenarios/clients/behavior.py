"""Stands, and plays a motion that is installed on the robot: behavior.py kick_right"""

import sys

from naoqi import ALProxy

ALProxy("ALMotion").wakeUp()
ALProxy("ALRobotPosture").goToPosture("StandInit", 0.8)
ALProxy("ALBehaviorManager").runBehavior(sys.argv[1])
