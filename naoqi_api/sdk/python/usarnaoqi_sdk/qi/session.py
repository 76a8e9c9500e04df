"""qi.Session: connected when asked, to the address asked for or that of the environment."""

import threading
from typing import Any, Callable, List, Optional

from ..address import addressOfUrl
from ..errors import CallError, ConnectionLost
from ..future import Future
from ..session import ServiceInfo
from ..session import Session as Wire
from ..signals import Signal
from .tasks import async_

DIRECTORY_SIGNALS = {"serviceRegistered": "serviceAdded", "serviceUnregistered": "serviceRemoved"}


class Session:
    """With every method, `_async=True` returns a future."""

    def __init__(self, url: str = ""):
        self._wire: Optional[Wire] = None
        self._lock = threading.Lock()
        self._where = ""
        self.connected = Signal("()")
        self.disconnected = Signal("(s)")
        self.serviceRegistered = Signal("(Is)")
        self.serviceUnregistered = Signal("(Is)")
        if url:
            self.connect(url)

    def connect(self, url: str = "tcp://127.0.0.1:9559", _async: bool = False) -> Any:
        """Raises RuntimeError if nobody answers there."""
        return _maybe(_async, self._connect, url)

    def _connect(self, url: str) -> None:
        self._where = addressOfUrl(url)
        wire = Wire(self._where)
        directory = wire.service("ServiceDirectory")
        for ours, theirs in DIRECTORY_SIGNALS.items():
            getattr(directory, theirs).connect(getattr(self, ours))
        self._wire = wire
        wire.whenLost(self.disconnected)
        self.connected()

    def close(self, _async: bool = False) -> Any:
        return _maybe(_async, self._close)

    def _close(self) -> None:
        if self._wire:
            self._wire.close()

    def isConnected(self) -> bool:
        return self._wire is not None and self._wire.isConnected()

    def url(self) -> str:
        return "tcp://" + self._where if self._where else ""

    def endpoints(self) -> List[str]:
        """None: calls to this program's services come over its own connection."""
        return []

    def listen(self, _url: str = "", _async: bool = False) -> Any:
        """Nothing to do: calls to this program's services come over its own connection."""
        return _maybe(_async, lambda: None)

    def service(self, name: str, _async: bool = False) -> Any:
        """The service `name`. Raises RuntimeError if there is none."""
        return _maybe(_async, lambda: self._connected().service(str(name)))

    def services(self, _async: bool = False) -> Any:
        """What is known of each: `name`, `serviceId`, `machineId`, ..."""
        return _maybe(_async, lambda: [_described(info) for info in self._connected().services()])

    def registerService(self, name: str, target: Any, _async: bool = False) -> Any:
        """Makes any Python object a service; its number."""
        return _maybe(_async, lambda: self._connected().registerService(str(name), target))

    def unregisterService(self, number: int, _async: bool = False) -> Any:
        return _maybe(_async, lambda: self._connected().unregisterService(number))

    def waitForService(self, name: str, timeout: Optional[int] = None,
                       _async: bool = False) -> Any:
        """Until there is a service of that name, at most `timeout` ms."""
        return _maybe(_async, self._waitForService, name, timeout)

    def _waitForService(self, name: str, timeout: Optional[int]) -> None:
        there = threading.Event()
        link = self.serviceRegistered.connect(
            lambda _, added: there.set() if added == name else None)
        try:
            if name not in [info.name for info in self._connected().services()]:
                if not there.wait(None if timeout is None else timeout / 1000):
                    raise CallError("Service %s did not come within %d ms" % (name, timeout or 0))
        finally:
            self.serviceRegistered.disconnect(link)

    def setIdentity(self, _key: str, _certificate: str) -> None:
        """Of a listening address, of which there is none here."""

    def _connected(self) -> Wire:
        with self._lock:
            if self._wire is None or not self._wire.isConnected():
                raise ConnectionLost("Session is not connected")
            return self._wire


def _maybe(as_future: bool, work: Callable[..., Any], *arguments: Any) -> Any:
    future: Future = async_(work, *arguments) if as_future else None
    return future if as_future else work(*arguments)


def _described(info: ServiceInfo) -> dict:
    return {"name": info.name, "serviceId": info.id, "machineId": info.machine,
            "processId": info.process, "endpoints": list(info.endpoints),
            "sessionId": info.session, "objectUid": info.uid}
