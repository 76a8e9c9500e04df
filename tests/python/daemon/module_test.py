"""Modules and services of a program on a real daemon."""

import os
import queue
import threading
import unittest
from unittest import mock

from programs import enterDaemon, needsDaemon
from usarnaoqi_sdk import finder

finder.install()
import naoqi  # noqa: E402
import qi  # noqa: E402

SOON = 30  # s of the wall; reached only by a failing test


class Listener(naoqi.ALModule):
    """Notes what it is called with."""

    def __init__(self, name):
        naoqi.ALModule.__init__(self, name)
        self.heard = queue.Queue()
        self.gates = {"go": threading.Event()}

    def onEvent(self, key, value, message):
        """Three arguments, as ALMemory gives them."""
        self.heard.put((key, value, message))

    def onValue(self, *values):
        """Any number of them."""
        self.heard.put(values)

    def waitFor(self, gate):
        """Until somebody opens it."""
        self.gates[gate].wait(SOON)

    def double(self, value):
        """For other modules."""
        return value * 2


class Behavior(naoqi.ALBehavior):
    """Says how often it was started."""

    def __init__(self, name):
        naoqi.ALBehavior.__init__(self, name)
        self.setModuleDescription("Counts.")
        self.functionName("onInput_onStart", name, "Counts one more.")
        self.setReturn("count", "How often.")
        self.BIND_PYTHON(name, "onInput_onStart")
        self.starts = 0

    def onInput_onStart(self):
        """Counts one more."""
        self.starts += 1
        return self.starts


@needsDaemon
class ModuleTest(unittest.TestCase):
    def setUp(self):
        address = enterDaemon(self)
        patch = mock.patch.dict(os.environ, {"NAOQI_ADDRESS": address})
        patch.start()
        self.addCleanup(patch.stop)
        self.broker = naoqi.ALBroker("tests", "0.0.0.0", 0, "10.0.0.1", 9559)
        self.addCleanup(self.broker.shutdown)
        self.memory = naoqi.ALProxy("ALMemory", self.broker)

    def testEventsCallTheModule(self):
        listener = Listener("Listener")
        self.memory.subscribeToEvent("Ball", "Listener", "onEvent")
        self.memory.raiseEvent("Ball", [1, 2.5, "red"])
        self.assertEqual(listener.heard.get(timeout=SOON), ("Ball", [1, 2.5, "red"], ""))
        self.memory.unsubscribeToEvent("Ball", "Listener")
        self.memory.subscribeToMicroEvent("Goal", "Listener", "a message", "onValue")
        self.memory.raiseMicroEvent("Goal", 1)
        self.assertEqual(listener.heard.get(timeout=SOON), ("Goal", 1, "a message"))

    def testOthersCallTheModuleUntilItLeaves(self):
        listener = Listener("Doubler")
        other = qi.Session("tcp://10.0.0.1:9559")
        self.addCleanup(other.close)
        self.assertEqual(other.service("Doubler").double(21), 42)
        self.assertEqual(naoqi.ALProxy("Doubler").double("ab"), "abab")
        self.assertIn("Doubler", self.broker.getGlobalModuleList())
        with self.assertRaisesRegex(RuntimeError, "already registered"):
            Listener("Doubler")
        listener.exit()
        with self.assertRaisesRegex(RuntimeError, "Can't find service: Doubler"):
            naoqi.ALProxy("Doubler")

    def testAModuleHasWhatEveryModuleHas(self):
        listener = Listener("Standard")
        other = qi.Session("tcp://10.0.0.1:9559")
        self.addCleanup(other.close)
        remote = other.service("Standard")
        self.assertEqual(remote.pCall(["double", 4]), 8)
        self.assertTrue(remote.ping())
        self.assertIn("double", remote.getMethodList())
        self.assertIn("For other modules.", remote.getUsage("double"))
        with self.assertRaisesRegex(RuntimeError, "no method has the name triple"):
            remote.pCall(["triple", 4])
        with self.assertRaisesRegex(RuntimeError, "can not end a module"):
            remote.exit()
        listener.exit()

    def testOthersPostCallsOfTheModule(self):
        listener = Listener("Posted")
        proxy = naoqi.ALProxy("Posted", "10.0.0.1", 9559)
        task = proxy.post.waitFor("go")
        self.assertTrue(proxy.isRunning(task))
        self.assertTrue(proxy.wait(task, 1))  # the time-out came first
        listener.gates["go"].set()
        self.assertFalse(proxy.wait(task, 0))
        self.assertFalse(proxy.isRunning(task))
        listener.exit()

    def testABehaviorIsAModuleThatDescribesItself(self):
        behavior = Behavior("Starts")
        naoqi.autoBind(behavior)
        self.assertIsInstance(behavior, naoqi.ALDocable)
        self.assertEqual((behavior.getName(), behavior.getModuleHelp(), behavior.hasFinished),
                         ("Starts", "Counts.", False))
        self.assertIn("onInput_onStart", behavior.getMethodList())
        self.assertEqual(behavior.getMethodHelp("onInput_onStart"), "Counts one more.")
        behavior.onLoad()
        behavior.waitResources()
        proxy = naoqi.createModule("Starts")
        self.assertEqual([proxy.onInput_onStart() for _ in range(2)], [1, 2])
        behavior.releaseResource()
        behavior.onUnload()
        behavior.exit()

    def testTasksArePostedWaitedForAndStopped(self):
        motion = naoqi.ALProxy("ALMotion", "10.0.0.1", 9559)
        motion.setStiffnesses("Head", 1.0)
        task = motion.post.angleInterpolation("HeadYaw", 0.5, 2.0, True)
        self.assertTrue(motion.isRunning(task))
        self.assertFalse(motion.wait(task, 0))
        self.assertFalse(motion.isRunning(task))
        self.assertAlmostEqual(motion.getAngles("HeadYaw", False)[0], 0.5, places=5)
        task = motion.pCall("angleInterpolation", "HeadYaw", -0.5, 1000.0, True)
        motion.stop(task)
        self.assertFalse(motion.isRunning(task))

    def testServicesComeAndGoForWhoWatches(self):
        watching = qi.Session("tcp://10.0.0.1:9559")
        self.addCleanup(watching.close)
        gone = queue.Queue()
        watching.serviceUnregistered.connect(lambda _, name: gone.put(name))
        waiting = watching.waitForService("Late", _async=True)
        offering = qi.Session("tcp://10.0.0.1:9559")
        number = offering.registerService("Late", object())
        self.assertFalse(waiting.hasError(SOON * 1000))
        offering.unregisterService(number)
        self.assertEqual(gone.get(timeout=SOON), "Late")
        lost = queue.Queue()
        offering.disconnected.connect(lost.put)
        offering.close()
        self.assertIn("closed", lost.get(timeout=SOON))
        self.assertFalse(offering.isConnected())

    def testASignalOfAServicePassesThroughTheDaemon(self):
        class Clock:
            def __init__(self):
                self.tick = qi.Signal("(is)")
                self.alarm = qi.Signal()
                self.rate = qi.Property("f", 1.0)

        clock, heard = Clock(), queue.Queue()
        offering, using = qi.Session("tcp://x:1"), qi.Session("tcp://x:1")
        self.addCleanup(offering.close)
        self.addCleanup(using.close)
        offering.registerService("Clock", clock)
        remote = using.service("Clock")
        remote.tick.connect(lambda *values: heard.put(values))
        clock.tick(1, "one")  # connect() has ended: nothing is lost from now on
        self.assertEqual(heard.get(timeout=SOON), (1, "one"))
        remote.alarm.connect(lambda *values: heard.put(values))
        clock.alarm(2, ["two", 2.5])
        self.assertEqual(heard.get(timeout=SOON), (2, ["two", 2.5]))
        remote.rate.setValue(2)
        self.assertEqual((clock.rate.value(), remote.rate.value()), (2.0, 2.0))

    def testAnApplicationTakesItsUrlAndEndsWithItsSession(self):
        arguments = ["program", "--qi-url", "tcp://10.0.0.1:9559", "word", "--qi-log-level=5"]
        application = qi.Application(arguments)
        self.assertEqual((arguments, application.url), (["program", "word"],
                                                        "tcp://10.0.0.1:9559"))
        application.start()
        self.assertTrue(application.session.service("ALMemory").ping())
        stopping = qi.async_(application.session.close)
        application.run()  # until the session is lost
        self.assertFalse(stopping.hasError(SOON * 1000))


if __name__ == "__main__":
    unittest.main()
