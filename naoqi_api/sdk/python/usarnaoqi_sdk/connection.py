"""One socket: sends messages, and one thread reads the answers and the events."""

import itertools
import socket
import threading
from collections import deque
from typing import Any, Callable, Dict, Optional, Tuple

from .decoding import ObjectReader, decode
from .encoding import encode
from .errors import CallError, ConnectionLost, DecodeError, QiError
from .future import Future
from .message import FLAG_DYNAMIC, Kind, Message, Splitter
from .pool import runSafely

TERMINATE = 3
CANNOT_HANDLE = "The call request could not be handled."

Address = Tuple[int, int, int]  # service, object, action


class Connection:
    """Thread-safe. Calls made here are matched to their answers by number; events go to their
    subscribers on the reader's thread, which must not wait. Calls that come from the other side go
    to `host`, which is called as host(connection, message)."""

    def __init__(self, sock: socket.socket):
        self._socket = sock
        self._ids = itertools.count(1)
        self._send_lock = threading.Lock()
        self._lock = threading.Lock()  # guards the two maps and _lost
        self._pending: Dict[int, Tuple[Future, str]] = {}
        self._subscribers: Dict[Address, Tuple[str, Callable[..., None]]] = {}
        self._lost = ""
        self._discarded: deque = deque()
        self.on_lost: Callable[[str], None] = lambda reason: None
        self.host: Optional[Callable[["Connection", Message], None]] = None
        self.peer_capabilities: Dict[str, Any] = {}
        self.read_object: ObjectReader = _noObjects
        threading.Thread(target=self._read, name="qi reader", daemon=True).start()

    def call(self, service: int, obj: int, action: int, payload: bytes, returns: str,
             flags: int = 0) -> Future:
        """Sends a call; its answer will be of signature `returns`."""
        number = next(self._ids)
        future = Future(lambda: self._cancel(number, service, obj))
        with self._lock:
            if self._lost:
                raise ConnectionLost(self._lost)
            self._pending[number] = (future, returns)
        self._send(Message(Kind.CALL, number, service, obj, action, payload, flags))
        return future

    def post(self, service: int, obj: int, action: int, payload: bytes) -> None:
        """Sends a call that nobody answers."""
        self._send(Message(Kind.POST, next(self._ids), service, obj, action, payload))

    def emit(self, service: int, obj: int, action: int, payload: bytes) -> None:
        """Tells the other side, which subscribed, of an event of an object hosted here."""
        self._send(Message(Kind.EVENT, next(self._ids), service, obj, action, payload))

    def answer(self, request: Message, payload: bytes, kind: Kind = Kind.REPLY,
               flags: int = 0) -> None:
        """Answers a call of the other side; a post is not answered."""
        if request.kind == Kind.CALL:
            self._send(request._replace(kind=kind, flags=flags, payload=payload))

    def decode(self, signature: str, message: Message) -> Any:
        """The content of a message, of that signature unless the message says otherwise."""
        dynamic = message.flags & FLAG_DYNAMIC
        return decode("m" if dynamic else signature, message.payload, self.read_object)

    def sendCapabilities(self, capabilities: Dict[str, Any]) -> None:
        payload = encode("{sm}", capabilities)
        self._send(Message(Kind.CAPABILITY, next(self._ids), 0, 0, 0, payload))

    def subscribe(self, address: Address, signature: str, callback: Callable[..., None]) -> None:
        """Events of `address` call `callback(*arguments)` from now on."""
        with self._lock:
            self._subscribers[address] = (signature, callback)

    def unsubscribe(self, address: Address) -> None:
        with self._lock:
            self._subscribers.pop(address, None)

    def discard(self, service: int, obj: int) -> None:
        """Tells the service, with the next message, that an object it returned is not needed.
        Safe in a destructor: takes no lock."""
        self._discarded.append((service, obj))

    def isOpen(self) -> bool:
        return not self._lost

    def close(self) -> None:
        self._lose("the connection was closed")

    def _send(self, message: Message) -> None:
        data = b""
        while self._discarded:
            service, obj = self._discarded.popleft()
            data += Message(Kind.POST, next(self._ids), service, obj, TERMINATE,
                            encode("(I)", (service,))).toBytes()
        try:
            with self._send_lock:
                self._socket.sendall(data + message.toBytes())
        except OSError as error:
            self._lose("the connection broke: %s" % error)
            raise ConnectionLost(self._lost) from None

    def _cancel(self, number: int, service: int, obj: int) -> None:
        payload = encode("I", number)
        self._send(Message(Kind.CANCEL, next(self._ids), service, obj, 0, payload))

    def _read(self) -> None:
        splitter = Splitter()
        try:
            while True:
                data = self._socket.recv(1 << 18)
                if not data:
                    return self._lose("the other side closed the connection")
                for message in splitter.feed(data):
                    self._receive(message)
        except (OSError, QiError) as error:
            self._lose("the connection broke: %s" % error)

    def _receive(self, message: Message) -> None:
        if message.kind in (Kind.REPLY, Kind.ERROR, Kind.CANCELED):
            with self._lock:
                future, returns = self._pending.pop(message.id, (None, ""))
            if future:
                self._answer(future, returns, message)
        elif message.kind == Kind.EVENT:
            with self._lock:
                address = (message.service, message.object, message.action)
                subscriber = self._subscribers.get(address)
            if subscriber:
                self._deliver(message, *subscriber)
        elif message.kind == Kind.CAPABILITY:
            self.peer_capabilities.update(decode("{sm}", message.payload))
        elif self.host:
            self.host(self, message)
        elif message.kind == Kind.CALL:  # nothing lives at this end
            self.answer(message, encode("m", CANNOT_HANDLE), Kind.ERROR)

    def _answer(self, future: Future, returns: str, message: Message) -> None:
        if message.kind == Kind.CANCELED:
            return future.setCanceled()
        try:
            if message.kind == Kind.ERROR:
                return future.setError(CallError(str(decode("m", message.payload))))
            future.setValue(self.decode(returns, message))
        except DecodeError as error:
            future.setError(error)

    def _deliver(self, message: Message, signature: str, callback: Callable[..., None]) -> None:
        try:
            arguments = self.decode(signature, message)
        except DecodeError:
            return  # one event lost; the connection itself is sound
        runSafely(lambda: callback(*arguments))

    def _lose(self, reason: str) -> None:
        with self._lock:
            if self._lost:
                return
            self._lost = reason
            pending, self._pending = self._pending, {}
        try:
            self._socket.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass  # gone already
        self._socket.close()
        for future, _ in pending.values():
            future.setError(ConnectionLost(reason))
        self.on_lost(reason)


def _noObjects(_reader: Any) -> Any:
    raise DecodeError("an object came before the session was open")
