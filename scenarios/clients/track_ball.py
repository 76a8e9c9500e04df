"""Follows the red ball with the head for some seconds: track_ball.py seconds"""

import sys
import time

from naoqi import ALProxy

ALProxy("ALMotion").setStiffnesses("Head", 1.0)
tracker = ALProxy("ALTracker")
tracker.registerTarget("RedBall", 0.06)
tracker.setMode("Head")
tracker.track("RedBall")
time.sleep(float(sys.argv[1]))
tracker.stopTracker()
