"""The answer to a call that may still be under way."""

import threading
from typing import Any, Callable, Optional

from .errors import CallError


class Future:
    """Set once, by the connection's reader thread; may be waited for on any other thread."""

    def __init__(self, cancel: Optional[Callable[[], None]] = None):
        self._done = threading.Event()
        self._lock = threading.Lock()
        self._value: Any = None
        self._error: Optional[Exception] = None
        self._canceled = False
        self._cancel = cancel
        self._callbacks: list = []

    def value(self, timeout: Optional[float] = None) -> Any:
        """Waits, at most `timeout` seconds, for the answer; raises what the call raised."""
        if not self.wait(timeout):
            raise TimeoutError("no answer after %g s" % timeout)
        if self._error:
            raise self._error
        return self._value

    def wait(self, timeout: Optional[float] = None) -> bool:
        """Whether the answer is there, after at most `timeout` seconds."""
        return self._done.wait(timeout)

    def error(self) -> Optional[str]:
        """Waits; the error's text, or None."""
        self.wait()
        return str(self._error) if self._error else None

    def isFinished(self) -> bool:
        return self._done.is_set()

    def isRunning(self) -> bool:
        return not self._done.is_set()

    def isCanceled(self) -> bool:
        return self._canceled

    def hasError(self) -> bool:
        return self.error() is not None

    def cancel(self) -> None:
        """Asks the service to stop; the future ends when, and as, the service answers."""
        if self._cancel and self.isRunning():
            self._cancel()

    def addCallback(self, callback: Callable[["Future"], None]) -> None:
        """Calls `callback(future)` when done, on the reader thread: it must not call services."""
        with self._lock:
            if self.isRunning():
                self._callbacks.append(callback)
                return
        callback(self)

    def setValue(self, value: Any) -> None:
        self._value = value
        self._finish()

    def setError(self, error: Exception) -> None:
        self._error = error
        self._finish()

    def setCanceled(self) -> None:
        self._canceled = True
        self.setError(CallError("Call has been canceled."))

    def _finish(self) -> None:
        with self._lock:
            self._done.set()
            callbacks, self._callbacks = self._callbacks, []
        for callback in callbacks:
            callback(self)
