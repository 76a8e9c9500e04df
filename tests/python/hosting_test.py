"""Objects of this program as the other end of a connection sees them."""

import functools
import queue
import socket
import threading
import unittest

import support  # noqa: F401  # finds the package
import qi
from usarnaoqi_sdk.connection import Connection
from usarnaoqi_sdk.errors import CallError
from usarnaoqi_sdk.hosted import Host, HostedObject
from usarnaoqi_sdk.remote_object import fetchObject, readObject

SOON = 10  # s; reached only by a failing test
SERVICE = 7


class Clock:
    """Tells the time."""

    def __init__(self):
        self.tick = qi.Signal("(is)")
        self.alarm = qi.Signal()
        self.rate = qi.Property("f", 1.0)
        self.promise = qi.Promise(lambda promise: promise.setCanceled())

    def now(self, zone="utc", *, _hidden=None):
        """What time it is."""
        return [zone, 12]

    @qi.bind(qi.Int32, (qi.Int32, qi.Float), "sum")
    def plus(self, a, b):
        return a + b

    @qi.nobind
    def secret(self):
        return "secret"

    def all(self, *values):
        return values

    def later(self):
        return self.promise.future()

    def fail(self):
        raise KeyError("key")

    def visit(self, guest):
        return guest.name("dear")

    def child(self):
        return Clock()

    def _inner(self):
        return None


class Guest:
    def name(self, word):
        return word + " guest"


class HostingTest(unittest.TestCase):
    def setUp(self):
        self.clock = Clock()
        ends = socket.socketpair()
        ours, theirs = [Connection(end) for end in ends]
        for connection in (ours, theirs):
            self.addCleanup(connection.close)
            connection.host = Host()
            connection.read_object = functools.partial(readObject, connection)
        ours.host.add(SERVICE, HostedObject(self.clock))
        self.remote = fetchObject(theirs, SERVICE, "Clock")

    def testOffersWhatIsPublicAndNotHidden(self):
        self.assertEqual(self.remote.meta.names(),
                         ["alarm", "all", "child", "fail", "later", "now", "rate", "sum", "tick",
                          "visit"])
        self.assertEqual(self.remote.meta.description, "Tells the time.")
        (now,) = {method.description for method in self.remote.meta.overloads("now")}
        self.assertEqual(now, "What time it is.")

    def testOptionalArgumentsAreOverloads(self):
        self.assertEqual(self.remote.now(), ["utc", 12])
        self.assertEqual(self.remote.now("cet"), ["cet", 12])
        with self.assertRaisesRegex(CallError, "Can't find method: now"):
            self.remote.now(1, 2)

    def testBoundTypesAreConvertedTo(self):
        self.assertEqual(self.remote.meta.overloads("sum")[0].arguments, "(if)")
        self.assertEqual(self.remote.sum(1.0, 2), 3)

    def testAnyNumberOfArgumentsIsTaken(self):
        self.assertEqual(self.remote.all(), ())
        self.assertEqual(self.remote.all(1, "x", [2.5, None]), (1, "x", [2.5, None]))

    def testAFutureIsAnsweredWhenItEnds(self):
        future = self.remote.later(_async=True)
        self.assertEqual(self.remote.now(), ["utc", 12])  # others are answered meanwhile
        self.clock.promise.setValue("done")
        self.assertEqual(future.value(SOON * 1000), "done")

    def testACallIsCanceledIfItsFutureCanBe(self):
        future = self.remote.later(_async=True)
        self.remote.now()  # the call has come before it is canceled
        future.cancel()
        future.wait(SOON * 1000)
        self.assertTrue(future.isCanceled())

    def testWhatAMethodRaisesIsTheCallersError(self):
        with self.assertRaisesRegex(CallError, "^KeyError: 'key'$"):
            self.remote.fail()

    def testSignalsReachWhoConnected(self):
        heard = queue.Queue()
        link = self.remote.tick.connect(lambda *values: heard.put(values))
        self.clock.tick(5, "five")
        self.assertEqual(heard.get(timeout=SOON), (5, "five"))
        self.remote.tick.disconnect(link)
        self.assertFalse(self.clock.tick.hasSubscribers())

    def testASignalWithoutASignatureCarriesWhateverItIsCalledWith(self):
        heard = queue.Queue()
        self.remote.alarm.connect(lambda *values: heard.put(values))
        events = [("one",), (1, "two"), (), ([1, 2],), ((3, 4),)]
        for values in events:
            self.clock.alarm(*values)
        self.assertEqual([heard.get(timeout=SOON) for _ in events], events)

    def testAClientMayEmitASignalWithoutASignature(self):
        heard = queue.Queue()
        self.clock.alarm.connect(lambda *values: heard.put(values))
        events = [(6, "six"), ([1, 2],)]
        for values in events:
            self.remote.alarm(*values)
        self.assertEqual([heard.get(timeout=SOON) for _ in events], events)

    def testASignalThatDoesNotFitIsTheEmittersError(self):
        self.remote.tick.connect(print)
        with self.assertRaises(CallError):
            self.clock.tick("no number", 5)

    def testAClientMayEmit(self):
        heard = queue.Queue()
        self.clock.tick.connect(lambda *values: heard.put(values))
        self.remote.tick(6, "six")
        self.assertEqual(heard.get(timeout=SOON), (6, "six"))

    def testPropertiesAreReadSetAndTold(self):
        heard = queue.Queue()
        self.remote.rate.connect(heard.put)
        self.remote.rate.setValue(2)
        self.assertEqual((self.remote.rate.value(), self.clock.rate.value()), (2.0, 2.0))
        self.assertEqual(heard.get(timeout=SOON), 2.0)
        self.assertEqual(self.remote.callId(7, "()", "[s]"), ["rate"])
        with self.assertRaises(CallError):
            self.remote.rate.setValue("fast")

    def testObjectsGoBothWays(self):
        self.assertEqual(self.remote.child().sum(1, 1), 2)
        self.assertEqual(self.remote.visit(Guest()), "dear guest")

    def testWhatIsNotThereIsAnError(self):
        with self.assertRaisesRegex(CallError, r"No such method \{7.1.999"):
            self.remote.callId(999, "()", "m")


class ThreadingTest(unittest.TestCase):
    """Two calls of one object: whether the second begins before the first has ended."""

    def overlap(self, cls):
        class Meeting(cls):
            def __init__(self):
                self.inside = threading.Semaphore(0)
                self.leave = threading.Event()

            def enter(self):
                self.inside.release()
                self.leave.wait(SOON)

        target = Meeting()
        hosted = HostedObject(target)
        hosted.run(target.enter)
        hosted.run(target.enter)
        self.assertTrue(target.inside.acquire(timeout=SOON))
        return target

    def testOneAtATimeUnlessTheClassSaysOtherwise(self):
        target = self.overlap(object)
        self.assertFalse(target.inside.acquire(blocking=False))
        target.leave.set()
        self.assertTrue(target.inside.acquire(timeout=SOON))

    def testMultiThreadedObjectsAreCalledAtOnce(self):
        target = self.overlap(qi.multiThreaded()(type("Base", (), {})))
        self.assertTrue(target.inside.acquire(timeout=SOON))
        target.leave.set()


if __name__ == "__main__":
    unittest.main()
