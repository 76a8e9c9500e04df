"""Wakes the robot up and walks to x y theta [m, m, rad], seen from where it stands."""

import sys

from naoqi import ALProxy

motion = ALProxy("ALMotion")
posture = ALProxy("ALRobotPosture")
motion.wakeUp()
posture.goToPosture("StandInit", 0.8)
motion.moveTo(*[float(number) for number in sys.argv[1:4]])
