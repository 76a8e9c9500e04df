"""Objects of this program that the other side calls: registered services, modules with callbacks,
objects passed as arguments."""

import hashlib
import itertools
import threading
import uuid
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

from .bound_types import MULTI, STANDARD, THREADING, OfferedMethod, ownMethods
from .connection import CANNOT_HANDLE, Connection
from .conversion import convert
from .encoding import Reference, Typed, encode
from .errors import CallError, DecodeError
from .future import Future
from .message import FLAG_DYNAMIC, FLAG_RETURN_TYPE, Kind, Message
from .metaobject import SIGNATURE, USER_IDS
from .pool import Strand, callbacks
from .signals import Property, Signal, newLink
from .signature import parse

REGISTER, UNREGISTER, META_OBJECT, TERMINATE = 0, 1, 2, 3
GET, SET, PROPERTIES, REGISTER_WITH_SIGNATURE = 5, 6, 7, 8
BASE_METHODS = (
    (REGISTER, "L", "registerEvent", "(IIL)"), (UNREGISTER, "v", "unregisterEvent", "(IIL)"),
    (META_OBJECT, SIGNATURE, "metaObject", "(I)"), (TERMINATE, "v", "terminate", "(I)"),
    (GET, "m", "property", "(m)"), (SET, "v", "setProperty", "(mm)"),
    (PROPERTIES, "[s]", "properties", "()"),
    (REGISTER_WITH_SIGNATURE, "L", "registerEventWithSignature", "(IILs)"))
FIRST_CLIENT_OBJECT = 0x80000000

_process = uuid.uuid4().bytes
_numbers = itertools.count()


class Subscription(NamedTuple):
    signal: Signal
    link: int  # ours, of the signal


class HostedObject:
    """One Python object as the other side sees it."""

    def __init__(self, target: Any, name: str = ""):
        self.target, self.name = target, name
        self.uid = hashlib.sha1(_process + str(next(_numbers)).encode()).digest()
        self.methods: Dict[int, OfferedMethod] = {}
        self.signals: Dict[int, Tuple[str, Signal]] = {}
        self._strand: Optional[Strand] = None
        if getattr(type(target), THREADING, None) != MULTI:
            self._strand = Strand(callbacks)
        ids = itertools.count(USER_IDS)
        standard = getattr(target, STANDARD, None)
        for method in standard(self.methods) if standard else []:
            self.methods[next(ids)] = method
        for method in ownMethods(target, list(self.methods.values())):
            self.methods[next(ids)] = method
        for name in dir(target):
            if not name.startswith("__") and isinstance(getattr(target, name, None), Signal):
                self.signals[next(ids)] = (name, getattr(target, name))

    def run(self, job: Callable[[], None]) -> None:
        (self._strand or callbacks).run(job)

    def metaObject(self) -> tuple:
        """As it travels."""
        methods = {uid: (uid, returns, name, arguments, "", [], "")
                   for uid, returns, name, arguments in BASE_METHODS}
        for uid, offer in self.methods.items():
            methods[uid] = (uid, offer.returns, offer.name, offer.arguments, offer.description,
                            [], "")
        signals = {uid: (uid, name, signal.tupleSignature())
                   for uid, (name, signal) in self.signals.items()}
        properties = {uid: (uid, name, signal.signature)
                      for uid, (name, signal) in self.signals.items()
                      if isinstance(signal, Property)}
        return methods, signals, properties, type(self.target).__doc__ or ""

    def property(self, key: Any) -> Property:
        """By its number or name."""
        for uid, (name, signal) in self.signals.items():
            if key in (uid, name) and isinstance(signal, Property):
                return signal
        raise CallError("property \"%s\" was not found" % key if isinstance(key, str)
                        else "cannot find property")


class Host:
    """The objects of one session, by service and number: answers what comes from the other side."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._objects: Dict[Tuple[int, int], HostedObject] = {}
        self._subscriptions: Dict[Tuple[Connection, int, int, int], Subscription] = {}
        self._running: Dict[Tuple[Connection, int], Future] = {}
        self._next = itertools.count(FIRST_CLIENT_OBJECT)

    def add(self, service: int, hosted: HostedObject) -> None:
        with self._lock:
            self._objects[service, 1] = hosted

    def remove(self, service: int) -> str:
        """Its name; "" if there was none of that number."""
        with self._lock:
            hosted = self._objects.pop((service, 1), None)
        return hosted.name if hosted else ""

    def lend(self, target: Any, connection: Connection, service: int) -> Reference:
        """`target` as a value to send in a call of, or an answer from, that service; the other side
        says when it needs it no more."""
        hosted, number = HostedObject(target), next(self._next)
        with self._lock:
            self._objects[service, number] = hosted
        data = encode(SIGNATURE, hosted.metaObject()) + encode("(II)", (service, number))
        if connection.peer_capabilities.get("ObjectPtrUID"):
            data += hosted.uid
        return Reference(data)

    def __call__(self, connection: Connection, message: Message) -> None:
        """On the reader's thread: what takes time goes to the object's own."""
        with self._lock:
            hosted = self._objects.get((message.service, message.object))
        if message.kind == Kind.CANCEL:
            self._cancel(connection, message)
        elif message.kind not in (Kind.CALL, Kind.POST):
            return
        elif not hosted:
            connection.answer(message, encode("m", CANNOT_HANDLE), Kind.ERROR)
        else:
            work = _Work(self, connection, message, hosted)
            work.run() if message.action < USER_IDS else hosted.run(work.run)

    def subscribe(self, connection: Connection, message: Message, uid: int, link: int,
                  signal: Signal) -> None:
        key = (connection, message.service, message.object, link)

        def tell(values: tuple) -> None:
            if not connection.isOpen():
                signal.disconnect(ours)
                return
            event = self.exported(values, connection, message.service)
            payload = encode(signal.tupleSignature(), convert(signal.tupleSignature(), event))
            connection.emit(message.service, message.object, uid, payload)

        ours = newLink()
        self._subscriptions[key] = Subscription(signal, ours)
        signal.listen(ours, tell)

    def unsubscribe(self, connection: Connection, message: Message, link: int) -> None:
        found = self._subscriptions.pop((connection, message.service, message.object, link), None)
        if not found:
            raise CallError("Unregister request failed for %d %d" % (link, message.object))
        found.signal.disconnect(found.link)

    def terminate(self, message: Message) -> None:
        if message.object >= FIRST_CLIENT_OBJECT:
            with self._lock:
                self._objects.pop((message.service, message.object), None)

    def started(self, connection: Connection, message: Message, future: Future) -> None:
        self._running[connection, message.id] = future
        future.whenDone(lambda: self._running.pop((connection, message.id), None))

    def _cancel(self, connection: Connection, message: Message) -> None:
        try:
            future = self._running.get((connection, connection.decode("I", message)))
        except DecodeError:
            return
        if future:
            future.cancel()

    def exported(self, value: Any, connection: Connection, service: int) -> Any:
        """`value` with every object of a class of its own, within it too, ready to travel."""
        if isinstance(value, (Typed, Reference)):
            return value
        if isinstance(value, (list, tuple)):
            parts = [self.exported(part, connection, service) for part in value]
            return parts if isinstance(value, list) else tuple(parts)
        if isinstance(value, dict):
            return {key: self.exported(part, connection, service) for key, part in value.items()}
        if _isPlain(value):
            return value
        own = getattr(value, "referenceFor", None)
        return own(connection) if own else self.lend(value, connection, service)


def _isPlain(value: Any) -> bool:
    return (value is None or isinstance(value, (str, bytes, bytearray, memoryview, bool, int,
                                                float)) or hasattr(value, "tolist")
            or hasattr(value, "__index__") or hasattr(value, "__float__"))


class _Work:
    """One call of the other side."""

    def __init__(self, host: Host, connection: Connection, message: Message,
                 hosted: HostedObject):
        self._host, self._connection, self._message = host, connection, message
        self._hosted = hosted

    def run(self) -> None:
        try:
            returns, value = self._do()
        except Exception as error:  # pylint: disable=broad-except  # becomes the caller's error
            return self._fail(str(error) if isinstance(error, RuntimeError) else
                              "%s: %s" % (type(error).__name__, error))
        if not isinstance(value, Future):
            return self._reply(returns, value)
        self._host.started(self._connection, self._message, value)
        value.whenDone(lambda: self._finish(returns, value))

    def _finish(self, returns: str, future: Future) -> None:
        if future.isCanceled():
            self._answer(b"", Kind.CANCELED)
        elif future.hasError():
            self._fail(future.error() or "")
        else:
            self._reply(returns, future.value())

    def _do(self) -> Tuple[str, Any]:
        uid = self._message.action
        if uid in _BASE:
            signature, returns, function = _BASE[uid]
            return returns, function(self, *self._arguments(signature))
        if uid in self._hosted.signals:  # a client may emit, too
            _, signal = self._hosted.signals[uid]
            return "v", signal(*self._arguments(signal.tupleSignature()))
        if uid not in self._hosted.methods:
            raise CallError("No such method {%d.%d.%d, id:%d}" % (
                self._message.service, self._message.object, uid, self._message.id))
        method = self._hosted.methods[uid]
        return method.returns, method.function(*self._arguments(method.arguments))

    def _arguments(self, signature: str) -> List[Any]:
        """Those of the call. What else the other side would like answered stays unheard."""
        if self._message.flags & FLAG_RETURN_TYPE:
            wanted = "m" if self._message.flags & FLAG_DYNAMIC else signature
            plain = self._message._replace(flags=0)
            value, _ = self._connection.decode("(%ss)" % wanted, plain)
        else:
            value = self._connection.decode(signature, self._message)
        if self._message.flags & FLAG_DYNAMIC and signature != "m":
            value = convert(signature, tuple(value) if isinstance(value, list) else value)
        return list(value) if isinstance(value, (list, tuple)) else [value]

    def _reply(self, returns: str, value: Any) -> None:
        if returns == "v":
            return self._answer(b"")
        try:
            ready = self._host.exported(value, self._connection, self._message.service)
            node = parse(returns)
            payload = encode(returns, ready if node.kind == "(" and node.name == "MetaObject"
                             else convert(returns, ready))
        except CallError as error:
            return self._fail(str(error))
        self._answer(payload)

    def _fail(self, text: str) -> None:
        self._answer(encode("m", text), Kind.ERROR)

    def _answer(self, payload: bytes, kind: Kind = Kind.REPLY) -> None:
        if self._connection.isOpen():
            self._connection.answer(self._message, payload, kind)

    def register(self, _service: int, uid: int, link: int, *_: Any) -> int:
        if uid not in self._hosted.signals:
            raise CallError("No such signal %d" % uid)
        _, signal = self._hosted.signals[uid]
        self._host.subscribe(self._connection, self._message, uid, link, signal)
        return link

    def unregister(self, _service: int, _uid: int, link: int) -> None:
        self._host.unsubscribe(self._connection, self._message, link)

    def metaObject(self, _: int) -> tuple:
        return self._hosted.metaObject()

    def terminate(self, _: int) -> None:
        self._host.terminate(self._message)

    def get(self, key: Any) -> Any:
        return self._hosted.property(key).value()

    def set(self, key: Any, value: Any) -> None:
        self._hosted.property(key).setValue(value)

    def properties(self) -> List[str]:
        return [name for name, signal in self._hosted.signals.values()
                if isinstance(signal, Property)]


_BASE = {REGISTER: ("(IIL)", "L", _Work.register), UNREGISTER: ("(IIL)", "v", _Work.unregister),
         META_OBJECT: ("(I)", SIGNATURE, _Work.metaObject),
         TERMINATE: ("(I)", "v", _Work.terminate), GET: ("(m)", "m", _Work.get),
         SET: ("(mm)", "v", _Work.set), PROPERTIES: ("()", "[s]", _Work.properties),
         REGISTER_WITH_SIGNATURE: ("(IILs)", "L", _Work.register)}
