"""Aldebaran's client module, over the same wire: programs written for a Nao run unchanged.

    from naoqi import ALProxy
    motion = ALProxy("ALMotion", "127.0.0.1", 9559)
    task = motion.post.moveTo(0.3, 0.0, 0.0)   # returns at once
    motion.wait(task, 0)

Addresses written into a program can be overridden from outside: NAOQI_ADDRESS=host[:port] replaces
host and port, NAO_IP=host the host alone.
"""

import os
import threading
from typing import Any, Callable, Dict, Optional

from usarnaoqi_sdk import CallError, ConnectionLost, RemoteObject, Session
from usarnaoqi_sdk.session import DEFAULT_PORT

__all__ = ["ALProxy"]

_sessions: Dict[str, Session] = {}
_sessions_lock = threading.Lock()


class ALProxy:
    """A service of the robot at `ip`: its methods are this object's. Errors are RuntimeErrors.
    Thread-safe; proxies of one address share one connection."""

    def __init__(self, name: str, ip: Optional[str] = None, port: int = DEFAULT_PORT):
        self._name = str(name)
        address = _address(ip, port)
        try:
            self._object: RemoteObject = _session(address).service(self._name)
        except ConnectionLost as error:
            raise RuntimeError("\tALProxy::ALProxy\n\t%s" % error) from None
        except CallError:
            raise RuntimeError("\tALProxy::ALProxy\n\tCan't find service: %s" % name) from None
        self.post = _Post(self)

    def __repr__(self):
        return "<ALProxy %s>" % self._name

    def __dir__(self):
        return sorted({"post", "call"} | set(self._object.meta.names()))

    def __getattr__(self, method: str) -> Callable[..., Any]:
        if method.startswith("__") and method.endswith("__"):
            raise AttributeError(method)
        return lambda *arguments: self.call(method, *arguments)

    def call(self, method: str, *arguments: Any) -> Any:
        """Calls `method` and waits for its answer."""
        try:
            return self._object.call(method, *arguments)
        except CallError as error:
            raise RuntimeError(_errorText(self._name, method, error)) from None

    def postCall(self, method: str, *arguments: Any) -> int:
        """Starts `method` as a task of the service; the number is for wait, isRunning, stop."""
        try:
            chosen = self._object.meta.choose(method, arguments)
            return self._object.call("__pCall", chosen.id, list(arguments))
        except CallError as error:
            raise RuntimeError(_errorText(self._name, method, error)) from None


class _Post:
    """`proxy.post.method(...)` starts a task and returns its number."""

    def __init__(self, proxy: ALProxy):
        self._proxy = proxy

    def __getattr__(self, method: str) -> Callable[..., int]:
        if method.startswith("__") and method.endswith("__"):
            raise AttributeError(method)
        return lambda *arguments: self._proxy.postCall(method, *arguments)


def _address(ip: Optional[str], port: int) -> str:
    override = os.environ.get("NAOQI_ADDRESS", "").replace("tcp://", "")
    host = override or os.environ.get("NAO_IP") or ip or "127.0.0.1"
    return host if ":" in host else "%s:%d" % (host, int(port))


def _session(address: str) -> Session:
    with _sessions_lock:
        session = _sessions.get(address)
        if not session or not session.isConnected():
            session = _sessions[address] = Session(address)
        return session


def _errorText(service: str, method: str, error: CallError) -> str:
    """As NaoQi words it: where on the first line, what on the second."""
    text = str(error)
    if text.lstrip().startswith(service + "::"):
        return text
    return "\t%s::%s\n\t%s" % (service, method, text)
