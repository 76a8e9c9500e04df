"""The answer to a call that may still be under way. Times are in milliseconds, as in libqi."""

import threading
from enum import IntEnum
from typing import Any, Callable, Optional

from .errors import CallError
from .pool import callbacks as pool

INFINITE = 0x7FFFFFFF  # ms; as a timeout: as long as it takes


class FutureState(IntEnum):
    NoneState = 0
    Running = 1
    Canceled = 2
    FinishedWithError = 3
    FinishedWithValue = 4


class FutureTimeout:
    """Names for timeouts."""

    Infinite = INFINITE
    NoneTimeout = 0


class Future:
    """Set once, by any thread; may be waited for on any other."""

    def __init__(self, cancel: Optional[Callable[[], None]] = None):
        self._done = threading.Event()
        self._lock = threading.Lock()
        self._state = FutureState.Running
        self._value: Any = None
        self._error: Optional[Exception] = None
        self._cancel = cancel
        self._listeners: list = []

    def value(self, timeout: Optional[float] = None) -> Any:
        """Waits, at most `timeout` ms, for the answer; raises what the call raised."""
        self._waitFor(timeout)
        if self._error:
            raise self._error
        return self._value

    def wait(self, timeout: Optional[float] = None) -> FutureState:
        """The state, after at most `timeout` ms."""
        self._done.wait(None if timeout is None or timeout >= INFINITE else max(0, timeout) / 1000)
        return self._state

    def error(self, timeout: Optional[float] = None) -> Optional[str]:
        """Waits; the error's text, or None."""
        self._waitFor(timeout)
        return str(self._error) if self._error else None

    def state(self) -> FutureState:
        return self._state

    def isFinished(self) -> bool:
        return self._done.is_set()

    def isRunning(self) -> bool:
        return not self._done.is_set()

    def isCanceled(self) -> bool:
        return self._state == FutureState.Canceled

    def isCancelable(self) -> bool:
        return self._cancel is not None

    def isCancellable(self) -> bool:
        return self.isCancelable()

    def hasError(self, timeout: Optional[float] = None) -> bool:
        self._waitFor(timeout)
        return self._state == FutureState.FinishedWithError

    def hasValue(self, timeout: Optional[float] = None) -> bool:
        self._waitFor(timeout)
        return self._state == FutureState.FinishedWithValue

    def cancel(self) -> None:
        """Asks the service to stop; the future ends when, and as, the service answers."""
        if self._cancel and self.isRunning():
            self._cancel()

    def addCallback(self, callback: Callable[["Future"], Any]) -> None:
        """Calls `callback(future)` when done, on a thread of its own, which may call services."""
        self.whenDone(lambda: pool.run(lambda: callback(self)))

    def then(self, callback: Callable[["Future"], Any]) -> "Future":
        """The future of `callback(self)`, which is called when this one is done."""
        promise = Promise(lambda _: self.cancel())
        self.addCallback(lambda done: promise.setFrom(lambda: callback(done)))
        return promise.future()

    def andThen(self, callback: Callable[[Any], Any]) -> "Future":
        """The future of `callback(value)`; an error, or a cancellation, is passed on instead."""
        promise = Promise(lambda _: self.cancel())

        def go(done: "Future") -> None:
            if done.hasValue():
                promise.setFrom(lambda: callback(done.value()))
            else:
                done.passTo(promise)

        self.addCallback(go)
        return promise.future()

    def unwrap(self) -> "Future":
        """For a future whose value is a future: a future of that one's value."""
        promise = Promise(lambda _: self.cancel())

        def go(done: "Future") -> None:
            inner = done.value() if done.hasValue() else None
            if isinstance(inner, Future):
                inner.whenDone(lambda: inner.passTo(promise))
            else:
                done.passTo(promise)

        self.addCallback(go)
        return promise.future()

    def __await__(self):
        import asyncio  # only programs that await have a loop
        loop = asyncio.get_running_loop()
        ready = loop.create_future()
        self.whenDone(lambda: loop.call_soon_threadsafe(
            lambda: ready.done() or ready.set_result(None)))
        yield from ready
        return self.value()

    def whenDone(self, job: Callable[[], None]) -> None:
        """Calls `job()` when done, on the thread that ends the future: it must not wait."""
        with self._lock:
            if self.isRunning():
                self._listeners.append(job)
                return
        job()

    def passTo(self, promise: "Promise") -> None:
        """Ends the promise as this future, which is done, ended."""
        if self.isCanceled():
            promise.setCanceled()
        elif self._error:
            promise.setError(self._error)
        else:
            promise.setValue(self._value)

    def setValue(self, value: Any) -> None:
        self._value = value
        self._finish(FutureState.FinishedWithValue)

    def setError(self, error: Exception) -> None:
        self._error = error
        self._finish(FutureState.FinishedWithError)

    def setCanceled(self) -> None:
        self._error = CallError("Call has been canceled.")
        self._finish(FutureState.Canceled)

    def _waitFor(self, timeout: Optional[float]) -> None:
        if self.wait(timeout) == FutureState.Running:
            raise FutureTimedOut("Future timeout: no answer after %g ms" % timeout)

    def _finish(self, state: FutureState) -> None:
        with self._lock:
            self._state = state
            self._done.set()
            listeners, self._listeners = self._listeners, []
        for job in listeners:
            job()


class FutureTimedOut(CallError, TimeoutError):
    """The answer did not come in the time given."""


class Promise:
    """The other end of a future: who makes it ends it, once."""

    def __init__(self, on_cancel: Optional[Callable[["Promise"], None]] = None):
        self._on_cancel = on_cancel
        self._cancel_requested = False
        self._claim = threading.Lock()
        self._future = Future(self._cancel)

    def future(self) -> Future:
        return self._future

    def isCancelRequested(self) -> bool:
        return self._cancel_requested

    def setValue(self, value: Any) -> None:
        self._claimed()
        self._future.setValue(value)

    def setError(self, error: Any) -> None:
        self._claimed()
        self._future.setError(error if isinstance(error, Exception) else CallError(str(error)))

    def setCanceled(self) -> None:
        self._claimed()
        self._future.setCanceled()

    def setFrom(self, work: Callable[[], Any]) -> None:
        """The value is what `work()` returns, or the error what it raises."""
        try:
            value = work()
        except Exception as error:  # pylint: disable=broad-except  # told to who waits
            return self.setError(error if isinstance(error, RuntimeError) else
                                 CallError("%s: %s" % (type(error).__name__, error)))
        self.setValue(value)

    def _cancel(self) -> None:
        self._cancel_requested = True
        if self._on_cancel:
            self._on_cancel(self)

    def _claimed(self) -> None:
        if not self._claim.acquire(blocking=False):
            raise CallError("the promise has been kept already")


def futureBarrier(futures: list) -> Future:
    """The future of the list of `futures`, done when all of them are."""
    promise = Promise(lambda _: [future.cancel() for future in futures])
    left = [len(futures)]
    lock = threading.Lock()

    def one() -> None:
        with lock:
            left[0] -= 1
            if left[0]:
                return
        promise.setValue(list(futures))

    if not futures:
        promise.setValue([])
    for future in futures:
        future.whenDone(one)
    return promise.future()
