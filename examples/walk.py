#!/usr/bin/env python3
"""Walks 30 cm ahead, watching the odometry on the way, and sits down again."""

import sys
import time

from naoqi import ALProxy

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 9559

motion = ALProxy("ALMotion", ip, port)
motion.wakeUp()
ALProxy("ALRobotPosture", ip, port).goToPosture("StandInit", 0.5)
task = motion.post.moveTo(0.3, 0.0, 0.0)  # m, m, rad; returns at once
while motion.isRunning(task):
    x, y, theta = motion.getRobotPosition(True)
    print("odometry: x %.2f m, y %.2f m, heading %.1f deg" % (x, y, theta * 57.2958))
    time.sleep(0.5)
motion.rest()
