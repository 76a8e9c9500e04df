"""qi without a robot: types, decorators, logging, tasks, applications."""

import contextlib
import io
import queue
import unittest

import support  # noqa: F401  # finds the package
import qi
from qi import logging

SOON = 10000  # ms; far more than a task takes, and reached only by a failing test


class TypesTest(unittest.TestCase):
    def testTypesAreSignatures(self):
        types = [qi.Bool, qi.Int8, qi.UInt64(), qi.List(qi.String), qi.Map(qi.String, qi.Dynamic),
                 qi.Struct((qi.Int32, qi.List(qi.Float)))]
        self.assertEqual([str(one) for one in types], ["b", "c", "L", "[s]", "{sm}", "(i[f])"])
        self.assertEqual(qi.List(qi.Int32), qi.List(qi.Int32))

    def testValuesHaveTypes(self):
        self.assertEqual([str(qi.typeof(value)) for value in (True, 1, 1.5, "x", [1], {"a": 1})],
                         ["b", "l", "d", "s", "[m]", "{mm}"])
        self.assertTrue(qi.isinstance_(3, qi.Int64))
        with self.assertRaises(TypeError):
            qi.typeof(object())


class SignalTest(unittest.TestCase):
    def testTellsEveryoneInOrderUntilDisconnected(self):
        heard, signal = queue.Queue(), qi.Signal("(i)")
        link = signal.connect(heard.put)
        for value in range(20):
            signal(value)
        self.assertEqual([heard.get(timeout=SOON / 1000) for _ in range(20)], list(range(20)))
        self.assertTrue(signal.disconnect(link))
        self.assertFalse(signal.disconnect(link))
        signal(21)
        self.assertTrue(heard.empty())

    def testASignalMayBeConnectedToASignal(self):
        heard, first, second = queue.Queue(), qi.Signal(), qi.Signal()
        first.connect(second)
        second.connect(lambda *values: heard.put(values))
        first(1, "two")
        self.assertEqual(heard.get(timeout=SOON / 1000), (1, "two"))

    def testAPropertyTellsItsChanges(self):
        heard, level = queue.Queue(), qi.Property("f", 1.0)
        level.connect(heard.put)
        level.setValue(1)  # as it is
        level.setValue(2)
        self.assertEqual((heard.get(timeout=SOON / 1000), level.value()), (2.0, 2.0))
        with self.assertRaises(RuntimeError):
            level.setValue("high")
        self.assertEqual(level.value(_async=True).value(SOON), 2.0)


class TasksTest(unittest.TestCase):
    def testAsyncIsTheFutureOfACall(self):
        self.assertEqual(qi.async_(max, 2, 5).value(SOON), 5)
        self.assertEqual(qi.runAsync(lambda: "later", delay=1000).value(SOON), "later")
        self.assertEqual(getattr(qi, "async"), qi.async_)
        self.assertIn("ZeroDivisionError", qi.async_(divmod, 1, 0).error(SOON))

    def testACallThatHasNotBegunIsCanceled(self):
        future = qi.async_(lambda: None, delay=100000)  # us
        future.cancel()
        future.wait(SOON)
        self.assertTrue(future.isCanceled())

    def testAPeriodicTaskRunsUntilItIsStopped(self):
        counts, task = queue.Queue(), qi.PeriodicTask()
        with self.assertRaises(RuntimeError):
            task.start(True)
        task.setCallback(lambda: counts.put(task.isRunning()))
        task.setUsPeriod(1000)
        task.start(True)
        self.assertEqual([counts.get(timeout=SOON / 1000) for _ in range(3)], [True] * 3)
        task.stop()
        self.assertEqual((task.isRunning(), task.isStopping()), (False, False))

    def testItMayStopItself(self):
        task, done = qi.PeriodicTask(), qi.Promise()

        def once():
            task.stop()
            done.setValue("stopped")

        task.setCallback(once)
        task.setUsPeriod(1000)
        task.start(False)
        self.assertEqual(done.future().value(SOON), "stopped")


class LoggingTest(unittest.TestCase):
    def setUp(self):
        self.addCleanup(logging.setLevel, logging.INFO)

    def lines(self, work):
        with contextlib.redirect_stderr(io.StringIO()) as out:
            work()
        return [line.split(" ", 2)[2] for line in out.getvalue().splitlines()]

    def testTellsWhatIsImportantEnough(self):
        def log():
            logger = qi.Logger("my.category")
            logger.info("two", 2)
            logger.verbose("not told")
            qi.warning("other", "one")

        self.assertEqual(self.lines(log), ["my.category: two 2", "other: one"])

    def testFiltersGoByCategory(self):
        def log():
            logging.setFilters("*=ERROR:my.*=DEBUG:-my.noise")
            for category in ("my.self", "my.noise", "other"):
                logging.logInfo(category, "hello")

        self.assertEqual(self.lines(log), ["my.self: hello"])


class ApplicationTest(unittest.TestCase):
    def testTakesItsOptionsAndLeavesTheOthers(self):
        arguments = ["name", "--qi-url=tcp://nao:1", "--speed", "3", "--qi-standalone", "last"]
        application = qi.Application(arguments)
        self.assertEqual(application.url, "tcp://nao:1")
        self.assertEqual(arguments, ["name", "--speed", "3", "last"])
        self.assertEqual(qi.Application(["name"], url="tcp://other:2").url, "tcp://other:2")

    def testASessionWithoutAConnectionSaysSo(self):
        session = qi.Session()
        self.assertFalse(session.isConnected())
        with self.assertRaisesRegex(RuntimeError, "not connected"):
            session.service("ALMotion")
        self.assertIn("not connected", session.service("ALMotion", _async=True).error(SOON))


if __name__ == "__main__":
    unittest.main()
