"""ALProxy: Aldebaran's names over the wire."""

import os
import unittest
from unittest import mock

from support import Kind, Server, answer, encode, failure
import naoqi
from usarnaoqi_sdk.decoding import decode
from usarnaoqi_sdk.metaobject import SIGNATURE

DIRECTORY = {100: ("service", "(s)", "(sIsI[s]s)")}
MOTION = {101: ("__pCall", "(I[m])", "i"), 108: ("wait", "(ii)", "b"),
          109: ("isRunning", "(i)", "b"), 110: ("stop", "(i)", "v"),
          130: ("setAngles", "(mmf)", "v"), 143: ("moveTo", "(fff)", "v"),
          144: ("moveTo", "(fffm)", "v"), 150: ("fail", "()", "v")}
SERVICES = {1: DIRECTORY, 2: MOTION}


def metaObject(methods):
    entries = {uid: (uid, returns, name, arguments, "", [], "")
               for uid, (name, arguments, returns) in methods.items()}
    return encode(SIGNATURE, (entries, {}, {}, ""))


class Robot:
    """As little of a NaoQi 2.1 as a proxy needs; notes the calls to ALMotion."""

    def __init__(self):
        self.calls = []
        self.server = Server(self.reply)

    def reply(self, message):
        if message.service == 0:
            return [answer(message, encode("{sm}", {"__qi_auth_state": 3, "MessageFlags": True}))]
        if message.action == 2:
            return [answer(message, metaObject(SERVICES[message.service]))]
        name, arguments, _ = SERVICES[message.service][message.action]
        values = decode(arguments, message.payload)
        if message.service == 1:
            return [self.info(message, *values)]
        self.calls.append((name,) + values)
        return [self.motion(message, name)]

    def info(self, message, name):
        if name != "ALMotion":
            return failure(message, "Cannot find service '%s' in index" % name)
        fields = (name, 2, "a-machine", 1, ["tcp://127.0.0.1:%d" % self.server.port], "1")
        return answer(message, encode("(sIsI[s]s)", fields))

    @staticmethod
    def motion(message, name):
        if name == "fail":
            return failure(message, "ALMotion::fail\n\tas asked")
        results = {"__pCall": encode("i", 7), "wait": encode("b", False),
                   "isRunning": encode("b", True)}
        return answer(message, results.get(name, b""))


class Proxy(unittest.TestCase):
    def setUp(self):
        self.robot = Robot()
        self.addCleanup(self.robot.server.close)
        patch = mock.patch.dict(os.environ)
        patch.start()
        self.addCleanup(patch.stop)
        os.environ.pop("NAO_IP", None)
        os.environ.pop("NAOQI_ADDRESS", None)

    def proxy(self, name="ALMotion"):
        return naoqi.ALProxy(name, "127.0.0.1", self.robot.server.port)

    def testMethodsAreAttributes(self):
        self.assertIsNone(self.proxy().setAngles("HeadYaw", 1, 0.1))
        name, joints, angles, fraction = self.robot.calls[-1]
        self.assertEqual((name, joints, angles), ("setAngles", "HeadYaw", 1))
        self.assertAlmostEqual(fraction, 0.1, places=6)  # it travels as a float

    def testPostStartsATaskThroughThePCall(self):
        motion = self.proxy()
        self.assertEqual(motion.post.moveTo(1, 0.5, 0, [["MaxStepX", 0.04]]), 7)
        self.assertEqual(self.robot.calls[-1],
                         ("__pCall", 144, [1, 0.5, 0, [["MaxStepX", 0.04]]]))

    def testTasksAreWaitedForAskedAboutAndStopped(self):
        motion = self.proxy()
        self.assertFalse(motion.wait(7, 0))
        self.assertTrue(motion.isRunning(7))
        motion.stop(7)
        self.assertEqual(self.robot.calls, [("wait", 7, 0), ("isRunning", 7), ("stop", 7)])

    def testAnUnknownServiceIsNaoQisError(self):
        with self.assertRaisesRegex(RuntimeError,
                                    "^\tALProxy::ALProxy\n\tCan't find service: ALNope$"):
            self.proxy("ALNope")

    def testAnUnknownMethodIsNaoQisError(self):
        for call in (self.proxy().dance, self.proxy().post.dance):
            with self.assertRaisesRegex(
                    RuntimeError, r"^\tALMotion::dance\n\tCan't find method: dance \(resolved to "
                                  r"'\(b\)'\)$"):
                call(True)

    def testTheServicesOwnErrorTextIsKept(self):
        with self.assertRaisesRegex(RuntimeError, "^ALMotion::fail\n\tas asked$"):
            self.proxy().fail()

    def testNobodyListeningIsARuntimeError(self):
        self.robot.server.close()
        with self.assertRaisesRegex(RuntimeError, "Cannot connect to tcp://127.0.0.1:"):
            self.proxy()

    def testProxiesOfOneAddressShareOneConnection(self):
        self.proxy()
        self.proxy()
        opened = [message for message in self.robot.server.received if message.service == 0]
        self.assertEqual([message.kind for message in opened], [Kind.CALL])

    def testTheEnvironmentOverridesHardCodedAddresses(self):
        os.environ["NAOQI_ADDRESS"] = self.robot.server.address
        naoqi.ALProxy("ALMotion", "192.168.1.77", 9559).setAngles("HeadYaw", 0, 1)
        del os.environ["NAOQI_ADDRESS"]
        os.environ["NAO_IP"] = "127.0.0.1"
        naoqi.ALProxy("ALMotion", "192.168.1.77", self.robot.server.port).moveTo(1, 0, 0)
        self.assertEqual([call[0] for call in self.robot.calls], ["setAngles", "moveTo"])

    def testCopyingAndInspectingAProxyCallsNothing(self):
        motion = self.proxy()
        self.assertFalse(hasattr(motion, "__len__"))
        self.assertIn("moveTo", dir(motion))
        self.assertEqual(self.robot.calls, [])


if __name__ == "__main__":
    unittest.main()
