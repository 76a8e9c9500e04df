"""Work that runs later, or again and again. Delays and periods are in microseconds."""

import threading
import time
from typing import Any, Callable, Optional

from ..future import Future, Promise
from ..pool import callbacks, timer


def async_(function: Callable[..., Any], *arguments: Any, delay: int = 0,
           **named: Any) -> Future:
    """The future of `function(*arguments)`, which starts `delay` us from now."""
    canceled = threading.Event()
    promise = Promise(lambda _: canceled.set())

    def work() -> None:
        if canceled.is_set():
            promise.setCanceled()
        else:
            promise.setFrom(lambda: function(*arguments, **named))

    if delay > 0:
        timer.runAfter(delay / 1e6, work)
    else:
        callbacks.run(work)
    return promise.future()


runAsync = async_


class PeriodicTask:
    """Calls a function every period until it is stopped."""

    def __init__(self) -> None:
        self._callback: Optional[Callable[[], Any]] = None
        self._period = 0.0  # s
        self._compensate = False
        self._name = ""
        self._changed = threading.Condition()
        self._round = 0  # counts starts and stops: an old round knows that it is over
        self._active = False
        self._busy: Optional[threading.Thread] = None

    def setCallback(self, callback: Callable[[], Any]) -> None:
        self._callback = callback

    def setUsPeriod(self, period: int) -> None:
        self._period = period / 1e6

    setPeriod = setUsPeriod

    def compensateCallbackTime(self, compensate: bool) -> None:
        """Whether the period is from start to start, not from end to start."""
        self._compensate = bool(compensate)

    def setName(self, name: str) -> None:
        self._name = name

    def setStrand(self, _strand: Any) -> None:
        """A task never overlaps itself."""

    def start(self, immediate: bool) -> None:
        """Raises RuntimeError without a callback or a period."""
        if self._callback is None or self._period <= 0:
            raise RuntimeError("PeriodicTask: set a callback and a period first")
        with self._changed:
            if self._active:
                return
            self._active = True
            self._round += 1
            mine = self._round
        self._schedule(mine, 0 if immediate else self._period)

    def stop(self) -> None:
        """Waits for the call under way, unless it is the one that asks."""
        self.asyncStop()
        with self._changed:
            if self._busy is not threading.current_thread():
                self._changed.wait_for(lambda: self._busy is None)

    def asyncStop(self) -> None:
        with self._changed:
            self._active = False
            self._round += 1

    def isRunning(self) -> bool:
        return self._active

    def isStopping(self) -> bool:
        return not self._active and self._busy is not None

    def _schedule(self, mine: int, seconds: float) -> None:
        timer.runAfter(seconds, lambda: self._call(mine))

    def _call(self, mine: int) -> None:
        with self._changed:
            if mine != self._round:
                return
            self._busy = threading.current_thread()
        started = time.monotonic()
        try:
            self._callback()  # type: ignore[misc]
        finally:
            with self._changed:
                self._busy = None
                goes_on = mine == self._round
                self._changed.notify_all()
            if goes_on:
                spent = time.monotonic() - started if self._compensate else 0.0
                self._schedule(mine, max(0.0, self._period - spent))


def clockNow() -> int:
    """ns since some moment; never goes back."""
    return time.monotonic_ns()


steadyClockNow = clockNow


def systemClockNow() -> int:
    """ns since 1970."""
    return time.time_ns()
