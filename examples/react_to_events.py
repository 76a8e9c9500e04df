#!/usr/bin/env python3
"""A module with a callback: says how often the head was touched, until it was touched three times,
or until Ctrl-C."""

import sys
import threading

from naoqi import ALBroker, ALModule, ALProxy

ip = sys.argv[1] if len(sys.argv) > 1 else "127.0.0.1"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 9559


class Counter(ALModule):
    """A service of the robot as long as this program runs; ALMemory calls its method."""

    def __init__(self, name):
        ALModule.__init__(self, name)
        self.touches = 0
        self.done = threading.Event()
        self.speech = ALProxy("ALTextToSpeech")
        ALProxy("ALMemory").subscribeToEvent("FrontTactilTouched", name, "onTouched")

    def onTouched(self, key, value, message):
        """Called with the event's name, its value (1 touched, 0 let go) and a message."""
        if value == 0:
            return
        self.touches += 1
        print("%s: %d" % (key, self.touches), flush=True)
        self.speech.say("touch %d" % self.touches)
        if self.touches == 3:
            self.done.set()


broker = ALBroker("counting", "0.0.0.0", 0, ip, port)
counter = Counter("counter")  # the name under which the robot calls it
print("listening", flush=True)
try:
    counter.done.wait()
finally:
    broker.shutdown()
