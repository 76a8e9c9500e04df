"""Raises an event for every second of the run, five in all."""

import time

from naoqi import ALProxy

memory = ALProxy("ALMemory")
for second in range(1, 6):
    time.sleep(1)
    memory.raiseEvent("Test/Second", second)
