#!/usr/bin/env python3
"""qi's way: a call that is not waited for, a signal of ALMemory, and a service of this program that
others may ask."""

import sys

import qi


class Watcher:
    """A service: `last` is a property, `describe` a method."""

    def __init__(self):
        self.last = qi.Property("s", "nothing")

    def describe(self):
        """What was said last."""
        return "the robot said: " + self.last.value()


app = qi.Application(sys.argv)  # --qi-url tcp://host:port
app.start()
session = app.session

watcher, heard = Watcher(), qi.Promise()
session.registerService("Watcher", watcher)


def hear(text):
    """Called with every sentence, and with "" when it has been said."""
    if text and heard.future().isRunning():
        watcher.last.setValue(text)
        heard.setValue(text)


sentence = session.service("ALMemory").subscriber("ALTextToSpeech/CurrentSentence")
sentence.signal.connect(hear)

motion = session.service("ALMotion")
motion.setStiffnesses("Head", 1.0)
turning = motion.angleInterpolation("HeadYaw", [0.5], [1.0], True, _async=True)
session.service("ALTextToSpeech").say("turning")
turning.then(lambda done: print("turned to %.2f rad" % motion.getAngles("HeadYaw", True)[0])).wait()
heard.future().wait()
print(session.service("Watcher").describe())
