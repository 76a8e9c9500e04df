"""Futures: what follows them, how they end, what is told when they do not."""

import threading
import unittest

import support  # noqa: F401  # finds the package
from usarnaoqi_sdk.errors import CallError
from usarnaoqi_sdk.future import Future, FutureState, Promise, futureBarrier

SOON = 10000  # ms; far more than a callback takes, and reached only by a failing test


def finished(value):
    future = Future()
    future.setValue(value)
    return future


def failed(text):
    future = Future()
    future.setError(CallError(text))
    return future


class FutureTest(unittest.TestCase):
    def testItsStateIsThatOfItsEnd(self):
        canceled = Future()
        canceled.setCanceled()
        self.assertEqual([f.wait(SOON) for f in (finished(1), failed("x"), canceled)],
                         [FutureState.FinishedWithValue, FutureState.FinishedWithError,
                          FutureState.Canceled])
        self.assertTrue(Future().isRunning())
        self.assertEqual(Future().wait(0), FutureState.Running)

    def testAValueThatDoesNotComeInTimeIsARuntimeErrorAndATimeout(self):
        for kind in (RuntimeError, TimeoutError):
            with self.assertRaises(kind):
                Future().value(1)

    def testThenTakesTheFutureAndAndThenItsValue(self):
        self.assertEqual(finished(3).then(lambda f: f.value() + 1).value(SOON), 4)
        self.assertEqual(finished(3).andThen(lambda value: value * 2).value(SOON), 6)

    def testAndThenPassesAnErrorOnAndThenMayMendIt(self):
        called = []
        self.assertEqual(failed("broken").andThen(called.append).error(SOON), "broken")
        self.assertEqual(called, [])
        self.assertEqual(failed("broken").then(lambda f: f.error()).value(SOON), "broken")

    def testWhatAContinuationRaisesIsItsError(self):
        future = finished(0).andThen(lambda zero: 1 // zero)
        self.assertIn("ZeroDivisionError", future.error(SOON))

    def testUnwrapGivesTheInnerValue(self):
        self.assertEqual(finished(finished(5)).unwrap().value(SOON), 5)
        self.assertEqual(finished(failed("inside")).unwrap().error(SOON), "inside")

    def testACallbackMayWaitForAnotherFuture(self):
        first, second, order = Future(), Future(), []
        done = threading.Event()

        def wait(_):
            order.append(second.value(SOON))
            done.set()

        first.addCallback(wait)
        first.setValue(1)
        second.setValue(2)
        self.assertTrue(done.wait(SOON / 1000))
        self.assertEqual(order, [2])


class PromiseTest(unittest.TestCase):
    def testIsKeptOnce(self):
        promise = Promise()
        promise.setValue(1)
        with self.assertRaises(RuntimeError):
            promise.setError("too late")
        self.assertEqual(promise.future().value(SOON), 1)

    def testHearsOfACancelRequest(self):
        promise = Promise(lambda self: self.setCanceled())
        self.assertTrue(promise.future().isCancelable())
        promise.future().cancel()
        self.assertTrue(promise.isCancelRequested())
        self.assertTrue(promise.future().isCanceled())

    def testABarrierEndsWithTheLast(self):
        futures = [Future(), Future(), finished(3)]
        barrier = futureBarrier(futures)
        futures[1].setValue(2)
        self.assertTrue(barrier.isRunning())
        futures[0].setError(CallError("no"))
        self.assertEqual([f.hasError() for f in barrier.value(SOON)], [True, False, False])
        self.assertEqual(futureBarrier([]).value(SOON), [])


if __name__ == "__main__":
    unittest.main()
