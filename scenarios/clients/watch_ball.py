"""Looks for the red ball for some seconds: watch_ball.py seconds"""

import sys
import time

from naoqi import ALProxy

ball = ALProxy("ALRedBallDetection")
ball.subscribe("watch", 100, 0.0)
time.sleep(float(sys.argv[1]))
ball.unsubscribe("watch")
