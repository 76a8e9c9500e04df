"""Walks with a speed for some seconds, then stops: walk_pace.py x y theta seconds"""

import sys
import time

from naoqi import ALProxy

x, y, theta, seconds = [float(number) for number in sys.argv[1:5]]
motion = ALProxy("ALMotion")
motion.wakeUp()
ALProxy("ALRobotPosture").goToPosture("StandInit", 0.8)
motion.moveToward(x, y, theta)
time.sleep(seconds)
motion.stopMove()
