"""One socket: sends messages, and one thread reads the answers and the events."""

import itertools
import queue
import socket
import threading
import traceback
from collections import deque
from typing import Any, Callable, Dict, Tuple

from .decoding import ObjectReader, decode
from .encoding import encode
from .errors import CallError, ConnectionLost, DecodeError, QiError
from .future import Future
from .message import FLAG_DYNAMIC, Kind, Message, Splitter

TERMINATE = 3
CANNOT_HANDLE = "The call request could not be handled."

Address = Tuple[int, int, int]  # service, object, action


class Connection:
    """Thread-safe. Calls made here are matched to their answers by number; events go to their
    subscribers on a thread of their own, so that those may call services in turn."""

    def __init__(self, sock: socket.socket):
        self._socket = sock
        self._ids = itertools.count(1)
        self._send_lock = threading.Lock()
        self._lock = threading.Lock()  # guards the two maps and _lost
        self._pending: Dict[int, Tuple[Future, str]] = {}
        self._subscribers: Dict[Address, Tuple[str, Callable[..., None]]] = {}
        self._lost = ""
        self._discarded: deque = deque()
        self._events: queue.SimpleQueue = queue.SimpleQueue()
        self._event_thread = None
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

    def sendCapabilities(self, capabilities: Dict[str, Any]) -> None:
        payload = encode("{sm}", capabilities)
        self._send(Message(Kind.CAPABILITY, next(self._ids), 0, 0, 0, payload))

    def subscribe(self, address: Address, signature: str, callback: Callable[..., None]) -> None:
        """Events of `address` call `callback(*arguments)` from now on."""
        with self._lock:
            self._subscribers[address] = (signature, callback)
            if not self._event_thread:
                self._event_thread = threading.Thread(target=self._deliver, name="qi events",
                                                      daemon=True)
                self._event_thread.start()

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
                self._events.put((subscriber, message))
        elif message.kind == Kind.CAPABILITY:
            self.peer_capabilities.update(decode("{sm}", message.payload))
        elif message.kind == Kind.CALL:  # nothing lives at this end
            self._send(message._replace(kind=Kind.ERROR, flags=0,
                                        payload=encode("m", CANNOT_HANDLE)))

    def _answer(self, future: Future, returns: str, message: Message) -> None:
        if message.kind == Kind.CANCELED:
            return future.setCanceled()
        try:
            if message.kind == Kind.ERROR:
                return future.setError(CallError(str(decode("m", message.payload))))
            future.setValue(self._decode(returns, message))
        except DecodeError as error:
            future.setError(error)

    def _decode(self, signature: str, message: Message) -> Any:
        dynamic = message.flags & FLAG_DYNAMIC
        return decode("m" if dynamic else signature, message.payload, self.read_object)

    def _deliver(self) -> None:
        while True:
            event = self._events.get()
            if event is None:
                return
            (signature, callback), message = event
            try:
                arguments = self._decode(signature, message)
            except DecodeError:
                continue  # one event lost; the connection itself is sound
            try:
                callback(*arguments)
            except Exception:  # the subscriber's own mistake: shown, and the next event goes on
                traceback.print_exc()

    def _lose(self, reason: str) -> None:
        with self._lock:
            if self._lost:
                return
            self._lost = reason
            pending, self._pending = self._pending, {}
        self._events.put(None)
        try:
            self._socket.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass  # gone already
        self._socket.close()
        for future, _ in pending.values():
            future.setError(ConnectionLost(reason))


def _noObjects(_reader: Any) -> Any:
    raise DecodeError("an object came before the session was open")
