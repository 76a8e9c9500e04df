"""A service of the robot as `naoqi.ALProxy`."""

from typing import Any, Callable, Optional, Union

from ..address import address
from ..errors import CallError, ConnectionLost, QiError
from ..remote_object import RemoteObject
from ..session import Session
from .broker import ALBroker, currentBroker, sessionAt


class ALProxy:
    """A service of the robot: its methods are this object's. Errors are RuntimeErrors.
    Thread-safe; proxies of one address share one connection.

        ALProxy("ALMotion", "127.0.0.1", 9559)      an address
        ALProxy("ALMotion", broker)                 a broker
        ALProxy("ALMotion")                         the broker made last, or the environment
    """

    def __init__(self, name: str, ip: Union[str, ALBroker, None] = None,
                 port: Optional[int] = None, *_: Any):
        self._name = str(name)
        try:
            self._object: RemoteObject = _session(ip, port).service(self._name)
        except ConnectionLost as error:
            raise RuntimeError("\tALProxy::ALProxy\n\t%s" % error) from None
        except CallError:
            raise RuntimeError("\tALProxy::ALProxy\n\tCan't find service: %s" % name) from None
        self.post = _Post(self)

    def __repr__(self):
        return "<ALProxy %s>" % self._name

    def __dir__(self):
        return sorted({"call", "pCall", "post"} | set(self._object.meta.names()))

    def __getattr__(self, method: str) -> Callable[..., Any]:
        if method.startswith("__") and method.endswith("__"):
            raise AttributeError(method)
        caller = _Caller(self, method)
        self.__dict__[method] = caller
        return caller

    def call(self, method: str, *arguments: Any) -> Any:
        """Calls `method` and waits for its answer."""
        try:
            return self._object.call(method, *arguments)
        except (CallError, ConnectionLost) as error:
            raise RuntimeError(_errorText(self._name, method, error)) from None

    callvoid = callVoid = call

    def pCall(self, method: str, *arguments: Any) -> int:
        """Starts `method` as a task of the service; the number is for wait, isRunning, stop."""
        try:
            chosen = self._object.meta.choose(method, arguments)
            return self._object.call("__pCall", chosen.id, list(arguments))
        except (CallError, ConnectionLost) as error:
            raise RuntimeError(_errorText(self._name, method, error)) from None

    postCall = pCall

    def getModuleName(self) -> str:
        return self._name


class _Caller:
    """`proxy.method(...)`."""

    def __init__(self, proxy: ALProxy, method: str):
        self._proxy, self._method = proxy, method

    def __repr__(self):
        return "<%s.%s>" % (self._proxy.getModuleName(), self._method)

    def __call__(self, *arguments: Any) -> Any:
        return self._proxy.call(self._method, *arguments)


class _Post:
    """`proxy.post.method(...)` starts a task and returns its number."""

    def __init__(self, proxy: ALProxy):
        self._proxy = proxy

    def __getattr__(self, method: str) -> Callable[..., int]:
        if method.startswith("__") and method.endswith("__"):
            raise AttributeError(method)
        return lambda *arguments: self._proxy.pCall(method, *arguments)


def _session(ip: Union[str, ALBroker, None], port: Optional[int]) -> Session:
    broker = ip if isinstance(ip, ALBroker) else currentBroker() if ip is None else None
    if broker:
        return broker.session
    return sessionAt(address(None if ip is None else str(ip), port))


def _errorText(service: str, method: str, error: QiError) -> str:
    """As NaoQi words it: where on the first line, what on the second."""
    text = str(error)
    if text.lstrip().startswith(service + "::"):
        return text
    return "\t%s::%s\n\t%s" % (service, method, text)
