"""Asks for the battery's charge a hundred times, one after the other, and fails if that took longer
than so many seconds: ask_often.py seconds"""

import sys
import time

from naoqi import ALProxy

memory = ALProxy("ALMemory")
begin = time.time()
for _ in range(100):
    memory.getData("Device/SubDeviceList/Battery/Charge/Sensor/Value")
took = time.time() - begin
memory.insertData("Test/Took", took)
sys.exit(0 if took < float(sys.argv[1]) else 3)
