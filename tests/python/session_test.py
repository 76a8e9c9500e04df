"""A session against a server in this process that answers with recorded bytes, and only to the
bytes the recorded client sent."""

import gc
import queue
import socket
import struct
import threading
import unittest

from support import (Kind, Message, Replay, Server, answer, encode, failure, findRecorded)
from usarnaoqi_sdk import CallError, ConnectionLost, Session
from usarnaoqi_sdk.session import parseAddress, reachable

SOON = 10  # s; far more than a loopback answer takes, and reached only by a failing test


class WithServer(unittest.TestCase):
    def serve(self, reply):
        server = Server(reply)
        self.addCleanup(server.close)
        return server

    def connect(self, server):
        session = Session(server.address)
        self.addCleanup(session.close)
        return session


class RecordedConversation(WithServer):
    def setUp(self):
        self.server = self.serve(Replay())
        self.session = self.connect(self.server)
        self.demo = self.session.service("Demo")

    def testListsTheServices(self):
        self.assertEqual([info.name for info in self.session.services()],
                         ["ServiceDirectory", "Demo"])

    def testCallsReturnTheRecordedAnswers(self):
        self.assertEqual(self.demo.say("py"), "hello py")
        self.assertEqual(self.demo.add(1, 2), 3)
        self.assertEqual(self.demo.add(1.5, 2.5), 4.0)
        self.assertEqual(self.demo.add(1, 2.5), 3.5)
        self.assertEqual(self.demo.getAngles(["HeadYaw", "HeadPitch"], True), [0.25, 0.25])
        self.assertEqual(self.demo.amap(), {"a": 1, "b": 2})
        self.assertEqual(self.demo.raw(), b"\1\2\3\4")

    def testDynamicsTravelAsARealClientSendsThem(self):
        value = [1, "x", 2.5, True, None, {"k": [1, 2]}, (1, 2)]
        self.assertEqual(self.demo.echo(value), value)
        self.assertEqual(self.demo.echo(b"\0\1"), "\0\1")

    def testUnfittingArgumentsAreLeftToTheServer(self):
        with self.assertRaisesRegex(CallError, "conversion failure from String to List<String>"):
            self.demo.getAngles("HeadYaw", True)
        with self.assertRaisesRegex(CallError, "conversion failure from Int64 to String"):
            self.demo.say(3)

    def testErrorsCarryTheServersText(self):
        with self.assertRaisesRegex(CallError, "^deliberate failure$"):
            self.demo.fail()
        with self.assertRaisesRegex(CallError, "Cannot find service 'Nope' in index"):
            self.session.service("Nope")

    def testUnknownMembersAreSeenBeforeAnythingIsSent(self):
        count = len(self.server.received)
        with self.assertRaises(AttributeError):
            self.demo.noSuchThing()
        self.assertEqual(len(self.server.received), count)

    def testCancelEndsTheCall(self):
        future = self.demo.slow(1500, _async=True)
        future.cancel()
        with self.assertRaisesRegex(CallError, "canceled"):
            future.value(SOON * 1000)
        self.assertTrue(future.isCanceled())

    def testSignalsReachTheirSubscribers(self):
        ticks = queue.Queue()
        link = self.demo.tick.connect(lambda *values: ticks.put(values))
        self.demo.fire(5)
        self.assertEqual(ticks.get(timeout=SOON), (5, "tick"))
        self.demo.tick.disconnect(link)
        self.assertEqual(self.server.received[-1].action, 1)

    def testASubscriberMayCallTheService(self):
        answers = queue.Queue()
        self.demo.tick.connect(lambda count, _name: answers.put(self.demo.add(1, 2)))
        self.demo.fire(5)
        self.assertEqual(answers.get(timeout=SOON), 3)

    def testPropertiesAreReadSetAndWatched(self):
        self.assertEqual(self.demo.level.value(), 0.5)
        self.demo.level.setValue(0.9)
        levels = queue.Queue()
        link = self.demo.level.connect(levels.put)
        self.demo.level.setValue(0.3)
        self.assertAlmostEqual(levels.get(timeout=SOON), 0.3, places=6)  # it travels as a float
        self.demo.level.disconnect(link)

    def testReturnedObjectsAreCalledAndGivenBack(self):
        helper = self.demo.helper()
        self.assertEqual(helper.who(), "helper")
        del helper
        gc.collect()
        self.demo.add(1, 2)  # what is given back goes out with the next message
        recorded = findRecorded("C", Kind.POST, 3)
        posts = [message for message in self.server.received if message.kind == Kind.POST]
        self.assertEqual([(post.object, post.payload) for post in posts],
                         [(recorded.object, recorded.payload)])

    def testOneConnectionServesManyThreads(self):
        wrong = []

        def work():
            for _ in range(50):
                if self.demo.add(1, 2) != 3 or self.demo.say("py") != "hello py":
                    wrong.append(1)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Openings(WithServer):
    def testAServerFromBeforeAuthenticationGetsCapabilities(self):
        replay = Replay()

        def reply(message):
            if message.service == 0:
                return [failure(message, "no")] if message.kind == Kind.CALL else []
            return replay(message)

        server = self.serve(reply)
        self.assertEqual(self.connect(server).service("Demo").add(1, 2), 3)
        self.assertEqual(server.received[1].kind, Kind.CAPABILITY)

    def testRefusedCredentialsAreAnError(self):
        server = self.serve(lambda message: [failure(message, "wrong password")])
        with self.assertRaisesRegex(CallError, "wrong password"):
            Session(server.address, user="nao", token="guess")

    def testAnUnfinishedAuthenticationIsAnError(self):
        state = encode("{sm}", {"__qi_auth_state": 2})
        with self.assertRaisesRegex(CallError, "authentication failed"):
            Session(self.serve(lambda message: [answer(message, state)]).address)

    def testNobodyListeningIsAnError(self):
        with socket.create_server(("127.0.0.1", 0)) as listener:
            port = listener.getsockname()[1]
        with self.assertRaisesRegex(ConnectionLost, "Cannot connect to tcp://127.0.0.1:%d" % port):
            Session("127.0.0.1:%d" % port)


class Misbehaviour(WithServer):
    def openedThen(self, reply):
        """A server that opens as recorded and answers say() with `reply`."""
        replay = Replay()
        return self.serve(lambda message: reply(message) if message.action == 100 and
                          message.service == 2 else replay(message))

    def testAVanishingServerFailsTheCallsThatWait(self):
        demo = self.connect(self.openedThen(lambda message: None)).service("Demo")
        with self.assertRaises(ConnectionLost):
            demo.say("py")
        with self.assertRaises(ConnectionLost):
            demo.say("py")

    def testGarbageFailsTheCallsThatWait(self):
        demo = self.connect(self.openedThen(lambda message: [b"?" * 40])).service("Demo")
        with self.assertRaisesRegex(ConnectionLost, "does not speak qi"):
            demo.say("py")

    def testAnAnswerOfTheWrongTypeFailsThatCallOnly(self):
        server = self.openedThen(lambda message: [answer(message, b"\xff\xff\xff\xff")])
        demo = self.connect(server).service("Demo")
        with self.assertRaisesRegex(RuntimeError, "ends early"):
            demo.say("py")
        self.assertEqual(demo.add(1, 2), 3)

    def testAnswersToNobodyAreIgnored(self):
        server = self.openedThen(lambda message: [
            Message(Kind.REPLY, 999999, 2, 1, 100, b"?"), Message(Kind.EVENT, 5, 9, 9, 9, b"?"),
            answer(message, encode("s", "fine"))])
        self.assertEqual(self.connect(server).service("Demo").say("py"), "fine")

    def testCallsFromTheServerAreRefused(self):
        server = self.openedThen(lambda message: [
            Message(Kind.CALL, 77, 3, 1, 100, struct.pack("<I", 0)),
            answer(message, encode("s", "fine"))])
        demo = self.connect(server).service("Demo")
        demo.say("py")
        demo.add(1, 2)
        refusals = [message for message in server.received if message.kind == Kind.ERROR]
        self.assertEqual([refusal.id for refusal in refusals], [77])

    def testAWaitMayEndBeforeTheAnswer(self):
        demo = self.connect(self.openedThen(lambda message: [])).service("Demo")
        with self.assertRaises(TimeoutError):
            demo.say("py", _async=True).value(timeout=10)

    def testClosingFailsTheCallsThatWait(self):
        session = self.connect(self.openedThen(lambda message: []))
        future = session.service("Demo").say("py", _async=True)
        session.close()
        with self.assertRaisesRegex(ConnectionLost, "closed"):
            future.value(SOON * 1000)


class Addresses(unittest.TestCase):
    def testHaveADefaultPort(self):
        self.assertEqual(parseAddress("tcp://nao.local"), ("nao.local", 9559))
        self.assertEqual(parseAddress("10.0.0.2:1234"), ("10.0.0.2", 1234))

    def testThatAreNoneAreRefused(self):
        for text in ("", "tcp://", "nao:port", ":9559"):
            with self.subTest(text), self.assertRaises(ConnectionLost):
                parseAddress(text)

    def testLoopbackIsForThoseWhoDialledIt(self):
        endpoints = ["qi:Demo", "tcp://127.0.0.1:1", "tcp://10.0.0.2:2", "tcps://10.0.0.2:3"]
        self.assertEqual(reachable(endpoints, ("10.0.0.2", 2)), [("10.0.0.2", 2)])
        self.assertEqual(reachable(endpoints, ("localhost", 9)),
                         [("localhost", 1), ("10.0.0.2", 2)])


if __name__ == "__main__":
    unittest.main()
