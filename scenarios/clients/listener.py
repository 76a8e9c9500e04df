"""A module whose callback hears an event: listener.py Event Text. Says the text once it came."""

import sys
import threading

from naoqi import ALBroker, ALModule, ALProxy


class Listener(ALModule):
    """A service of the robot as long as this program runs; ALMemory calls its method."""

    def __init__(self, name, event):
        ALModule.__init__(self, name)
        self.heard = threading.Event()
        ALProxy("ALMemory").subscribeToEvent(event, name, "onEvent")

    def onEvent(self, key, value, message):
        """Called with the event's name, its value and a message."""
        if value:
            self.heard.set()


broker = ALBroker("listening", "0.0.0.0", 0, "127.0.0.1", 9559)
listener = Listener("listener", sys.argv[1])
try:
    listener.heard.wait()
    ALProxy("ALTextToSpeech").say(sys.argv[2])
finally:
    broker.shutdown()
