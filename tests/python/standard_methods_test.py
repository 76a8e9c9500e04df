"""The methods 100 to 112 of a Python module, as another program sees them, without a daemon."""

import functools
import socket
import threading
import unittest

import support  # noqa: F401  # finds the package
from usarnaoqi_sdk.al.module import ALModule
from usarnaoqi_sdk.connection import Connection
from usarnaoqi_sdk.future import Promise
from usarnaoqi_sdk.hosted import Host, HostedObject
from usarnaoqi_sdk.remote_object import fetchObject, readObject

SERVICE = 7
SOON_MS = 10000  # reached only by a failing test
# As every NaoQi module numbers them.
NUMBERS = {100: ("exit", "()", "v"), 101: ("__pCall", "(I[m])", "i"), 102: ("pCall", "(m)", "m"),
           103: ("version", "()", "s"), 104: ("ping", "()", "b"),
           105: ("getMethodList", "()", "[s]"), 106: ("getMethodHelp", "(s)", "m"),
           107: ("getModuleHelp", "()", "m"), 108: ("wait", "(ii)", "b"),
           109: ("isRunning", "(i)", "b"), 110: ("stop", "(i)", "v"),
           111: ("getBrokerName", "()", "s"), 112: ("getUsage", "(s)", "s")}


class Kicker(ALModule):
    """Kicks."""

    def __init__(self):  # pylint: disable=super-init-not-called  # no broker here
        self._module_name, self._broker, self._module_description = "Kicker", None, ""
        self.gate, self.promise = threading.Event(), Promise()

    def stop(self):
        """Its own, without a number."""
        return "stopped"

    def wait(self, seconds, why, who):
        return [seconds, why, who]

    def version(self):
        return "7"

    def kick(self):
        """Until the gate opens."""
        self.gate.wait(SOON_MS / 1000)

    def later(self):
        return self.promise.future()


class StandardMethods(unittest.TestCase):
    def setUp(self):
        self.module = Kicker()
        ours, theirs = [Connection(end) for end in socket.socketpair()]
        for connection in (ours, theirs):
            self.addCleanup(connection.close)
            connection.host = Host()
            connection.read_object = functools.partial(readObject, connection)
        ours.host.add(SERVICE, HostedObject(self.module))
        self.remote = fetchObject(theirs, SERVICE, "Kicker")

    def post(self, name, *arguments):
        chosen = self.remote.meta.choose(name, arguments)
        return self.remote.call("__pCall", chosen.id, list(arguments))

    def stops(self, task):
        try:
            self.remote.stop(task)
            return True
        except RuntimeError:
            return False

    def testHaveTheNumbersAndTypesOfEveryModule(self):
        found = {method.id: (method.name, method.arguments, method.returns)
                 for method in self.remote.meta.methods if 100 <= method.id <= 112}
        self.assertEqual(found, NUMBERS)

    def testTheModulesOwnOfTheSameNameAreThereToo(self):
        self.assertEqual(self.remote.stop(), "stopped")
        self.assertEqual(self.remote.wait(1, "because", "me"), [1, "because", "me"])
        self.assertEqual(self.remote.version(), "7")
        self.assertEqual(self.remote.pCall(["stop"]), "stopped")
        self.assertFalse(self.remote.wait(1234, 0))

    def testAPostedCallIsWaitedFor(self):
        task = self.post("kick")
        self.assertTrue(self.remote.isRunning(task))
        self.assertTrue(self.remote.wait(task, 1))
        with self.assertRaisesRegex(RuntimeError, "can not be stopped"):
            self.remote.stop(task)
        self.module.gate.set()
        self.assertFalse(self.remote.wait(task, SOON_MS))
        self.assertFalse(self.remote.isRunning(task))

    def testStoppingWhatHasEndedIsNoError(self):
        self.module.gate.set()
        task = self.post("kick")
        self.remote.wait(task, SOON_MS)
        self.assertIsNone(self.remote.stop(task))
        self.assertIsNone(self.remote.stop(1234))

    def testWhatEndsLaterRunsUntilThen(self):
        task = self.post("later")
        self.assertTrue(self.remote.wait(task, 1))
        self.assertTrue(self.remote.isRunning(task))
        self.module.promise.setValue(1)
        self.assertFalse(self.remote.wait(task, SOON_MS))

    def testStopCancelsWhatCanBeCanceled(self):
        self.module.promise = Promise(lambda promise: promise.setCanceled())
        task = self.post("later")
        while not self.stops(task):  # the method may not have come to its end yet
            self.remote.wait(task, 1)
        self.assertFalse(self.remote.wait(task, SOON_MS))

    def testTheyTellOfTheModule(self):
        self.assertEqual(self.remote.getModuleHelp(), ["Kicker", "Kicks."])
        self.assertEqual(self.remote.getMethodHelp("kick")[:2], ["kick", "Until the gate opens."])
        self.assertIn("kick()", self.remote.getUsage("kick"))
        self.assertTrue(set(self.remote.getMethodList()) >= {"kick", "ping", "pCall", "stop"})
        self.assertEqual((self.remote.ping(), self.remote.getBrokerName()), (True, ""))
        with self.assertRaisesRegex(RuntimeError, "can not end a module"):
            self.remote.exit()


if __name__ == "__main__":
    unittest.main()
