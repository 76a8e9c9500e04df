"""Signals and properties of objects that live in this program."""

import itertools
import threading
from typing import Any, Callable, Dict, Optional

from .conversion import convert
from .future import Future
from .pool import Strand, callbacks

_links = itertools.count(1)


def newLink() -> int:
    """A number that no other subscription has."""
    return next(_links)


class Signal:
    """Called, it tells everybody who connected: each in its order, on a thread that may call
    services."""

    def __init__(self, signature: str = "m", on_connect: Optional[Callable[[bool], None]] = None):
        self.signature = str(signature)
        self._on_connect = on_connect
        self._lock = threading.Lock()
        self._subscribers: Dict[int, Any] = {}

    def connect(self, callback: Any, *_: Any) -> int:
        """Calls `callback(*values)` for each event; the number is for disconnect(). A callback may
        be another signal."""
        strand, link = Strand(callbacks), newLink()
        self.listen(link, lambda values: strand.run(lambda: callback(*values)))
        return link

    def listen(self, link: int, job: Callable[[tuple], None]) -> None:
        """Calls `job(values)` on the emitter's own thread, which must not wait."""
        with self._lock:
            first = not self._subscribers
            self._subscribers[link] = job
        if first and self._on_connect:
            self._on_connect(True)

    def disconnect(self, link: int) -> bool:
        """Whether that link was connected."""
        with self._lock:
            found = self._subscribers.pop(link, None)
            last = found is not None and not self._subscribers
        if last and self._on_connect:
            self._on_connect(False)
        return found is not None

    def disconnectAll(self) -> bool:
        return all([self.disconnect(link) for link in list(self._subscribers)])

    def hasSubscribers(self) -> bool:
        return bool(self._subscribers)

    def __call__(self, *values: Any) -> None:
        with self._lock:
            subscribers = list(self._subscribers.values())
        for job in subscribers:
            job(values)

    def tupleSignature(self) -> str:
        """The signature of what an event carries to others: a tuple of the values, or "m", which
        holds the tuple of whatever they are."""
        return self.signature


class Property(Signal):
    """A value; whoever connected is told when it is set to another."""

    def __init__(self, signature: str = "m", value: Any = None,
                 on_connect: Optional[Callable[[bool], None]] = None):
        super().__init__(signature, on_connect)
        self._value = value

    def value(self, _async: bool = False) -> Any:
        return finished(self._value) if _async else self._value

    def setValue(self, value: Any, _async: bool = False) -> Any:
        """Raises CallError if the value does not fit the property's signature."""
        value = convert(self.signature, value)
        changed, self._value = value != self._value, value
        if changed:
            self(value)
        return finished(None) if _async else None

    def tupleSignature(self) -> str:
        return "(%s)" % self.signature


def finished(value: Any) -> Future:
    """A future that is done."""
    future = Future()
    future.setValue(value)
    return future
