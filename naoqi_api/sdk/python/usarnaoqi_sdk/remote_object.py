"""An object that lives in a service: its methods, signals and properties as attributes."""

import itertools
from typing import Any, Callable, Dict

from .connection import Connection
from .conversion import convert
from .decoding import Reader
from .encoding import Reference, Typed, encode
from .errors import CallError, ConversionError
from .future import Future
from .message import FLAG_DYNAMIC
from .metaobject import SIGNATURE, MetaObject, convertArguments
from .pool import Strand, callbacks
from .signals import finished
from .signature import parse

REGISTER_EVENT, UNREGISTER_EVENT, META_OBJECT, PROPERTY, SET_PROPERTY = 0, 1, 2, 5, 6
UID_BYTES = 20
SERVICE_OBJECT = 1  # the main object of a service

_links = itertools.count(1)


class RemoteObject:
    """`thing.method(...)` calls and waits, `thing.method(..., _async=True)` returns a Future,
    `thing.signal.connect(callback)` subscribes, `thing.property.value()` reads."""

    def __init__(self, connection: Connection, service: int, obj: int, meta: MetaObject,
                 name: str = ""):
        self._connection = connection
        self._service = service
        self._object = obj
        self._name = name or "object"
        self._members: Dict[str, Any] = {}
        self.meta = meta

    def __repr__(self):
        return "<%s on service %d, object %d>" % (self._name, self._service, self._object)

    def __dir__(self):
        return sorted(set(super().__dir__()) | set(self.meta.names()))

    def __del__(self):
        if self._object > SERVICE_OBJECT:
            self._connection.discard(self._service, self._object)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        if name not in self._members:
            self._members[name] = self._member(name)
        return self._members[name]

    def call(self, name: str, *arguments: Any) -> Any:
        """Calls the method `name` and waits for its answer."""
        return self.callAsync(name, *arguments).value()

    def callAsync(self, name: str, *arguments: Any) -> Future:
        """Calls without waiting. Arguments that do not fit are left to the service to judge;
        objects of this program go as such, and the other side may call them."""
        try:
            return self._callAsync(name, arguments)
        except CallError:
            host = self._connection.host
            if not hasattr(host, "exported"):
                raise
            return self._callAsync(name, host.exported(arguments, self._connection,
                                                       self._service))

    def _callAsync(self, name: str, arguments: tuple) -> Future:
        method = self.meta.choose(name, arguments)
        try:
            payload, flags = encode(method.arguments, convertArguments(method, arguments)), 0
        except ConversionError:
            if not self._connection.peer_capabilities.get("MessageFlags"):
                raise
            payload, flags = encode("m", arguments), FLAG_DYNAMIC
        return self._send(method.id, payload, method.returns, flags)

    def callId(self, action: int, arguments: str, returns: str, *values: Any) -> Any:
        """Calls an action every object has, by its number."""
        return self.callIdAsync(action, arguments, returns, *values).value()

    def callIdAsync(self, action: int, arguments: str, returns: str, *values: Any) -> Future:
        return self._send(action, encode(arguments, values), returns)

    def _send(self, action: int, payload: bytes, returns: str, flags: int = 0) -> Future:
        return self._connection.call(self._service, self._object, action, payload, returns, flags)

    def _member(self, name: str) -> Any:
        if self.meta.overloads(name):
            return _MethodCaller(self, name)
        if name in self.meta.properties:
            return Property(self, self._connection, self.meta.properties[name])
        if name in self.meta.signals:
            return Signal(self, self._connection, self.meta.signals[name])
        raise AttributeError("%s has no member '%s'" % (self._name, name))

    @property
    def address(self):
        return self._service, self._object

    def referenceFor(self, connection: Connection) -> Reference:
        """This object as a value to send back to where it lives."""
        if connection is not self._connection:
            raise CallError("%r lives elsewhere" % self)
        data = encode(SIGNATURE, self.meta.raw) + encode("(II)", self.address)
        uid = bytes(UID_BYTES) if connection.peer_capabilities.get("ObjectPtrUID") else b""
        return Reference(data + uid)


class _MethodCaller:
    def __init__(self, target: RemoteObject, name: str):
        self._target, self._name = target, name
        self.__doc__ = _describe(target.meta.overloads(name))

    def __call__(self, *arguments: Any, _async: bool = False, _overload: str = "") -> Any:
        future = self._target.callAsync(_overload or self._name, *arguments)
        return future if _async else future.value()


def _describe(methods: list) -> str:
    return "\n".join("%s::%s -> %s\n%s" % (method.name, method.arguments, method.returns,
                                          method.description) for method in methods)


class Signal:
    """One registration with the service however many callbacks there are."""

    def __init__(self, target: RemoteObject, connection: Connection, member: Any):
        self._target, self._connection, self._id = target, connection, member.id
        self._signature = member.signature
        self._callbacks: Dict[int, Callable[[tuple], None]] = {}
        self._link = 0

    def connect(self, callback: Callable[..., Any], _async: bool = False) -> Any:
        """Calls `callback(*values)` for each event: each in its order, on a thread that may call
        services. The number returned is for disconnect()."""
        link, strand = next(_links), Strand(callbacks)
        self._callbacks[link] = lambda values: strand.run(lambda: callback(*values))
        if not self._link:
            self._link = self._id << 32 | link
            service, obj = self._target.address
            self._connection.subscribe((service, obj, self._id), self._tuple(), self._emit)
            self._target.callId(REGISTER_EVENT, "(IIL)", "L", service, self._id, self._link)
        return finished(link) if _async else link

    def disconnectAll(self) -> None:
        for link in list(self._callbacks):
            self.disconnect(link)

    def __call__(self, *values: Any) -> None:
        """Emits the signal: all who subscribed are told."""
        service, obj = self._target.address
        payload = encode(self._tuple(), convert(self._tuple(), values))
        self._connection.post(service, obj, self._id, payload)

    def disconnect(self, link: int, _async: bool = False) -> Any:
        self._callbacks.pop(link, None)
        if not self._callbacks and self._link:
            service, obj = self._target.address
            remote, self._link = self._link, 0
            self._connection.unsubscribe((service, obj, self._id))
            self._target.callId(UNREGISTER_EVENT, "(IIL)", "v", service, self._id, remote)
        return finished(None) if _async else None

    def _tuple(self) -> str:
        return self._signature

    def _emit(self, *values: Any) -> None:
        for job in list(self._callbacks.values()):
            job(values)


class Property(Signal):
    """A value to read and set; connect() tells of its changes."""

    def value(self, _async: bool = False) -> Any:
        future = self._target.callIdAsync(PROPERTY, "(m)", "m", Typed("I", self._id))
        return future if _async else future.value()

    def setValue(self, value: Any, _async: bool = False) -> Any:
        future = self._target.callIdAsync(SET_PROPERTY, "(mm)", "v", Typed("I", self._id), value)
        return future if _async else future.value()

    def _tuple(self) -> str:
        return "(%s)" % self._signature


def fetchObject(connection: Connection, service: int, name: str) -> RemoteObject:
    """The main object of a service, which says itself what it offers."""
    payload = encode("(I)", (0,))
    future = connection.call(service, SERVICE_OBJECT, META_OBJECT, payload, SIGNATURE)
    return RemoteObject(connection, service, SERVICE_OBJECT, MetaObject(future.value()), name)


def readObject(connection: Connection, reader: Reader) -> Any:
    """An object reference within a payload: metaobject, service, object, and a uid if both ends
    send such."""
    meta = MetaObject(reader.value(parse(SIGNATURE)))
    service, obj = reader.u32(), reader.u32()
    if connection.peer_capabilities.get("ObjectPtrUID"):
        reader.bytes(UID_BYTES)
    return RemoteObject(connection, service, obj, meta) if obj else None

