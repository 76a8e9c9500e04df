"""Answers a touch of the head: says so, and ends."""

import time

from naoqi import ALProxy

memory = ALProxy("ALMemory")
speech = ALProxy("ALTextToSpeech")
while not memory.getData("Device/SubDeviceList/Head/Touch/Front/Sensor/Value"):
    time.sleep(0.05)
speech.say("Please do not touch my head")
