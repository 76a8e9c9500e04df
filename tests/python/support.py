"""Shared by the tests: where the package is, the recorded conversation, and a server that speaks
from it."""

import os
import socket
import struct
import sys
import threading
from collections import namedtuple

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "naoqi_api", "sdk", "python"))

from usarnaoqi_sdk import finder  # noqa: E402
from usarnaoqi_sdk.encoding import encode  # noqa: E402
from usarnaoqi_sdk.message import Kind, Message, Splitter  # noqa: E402

finder.install()
Recorded = namedtuple("Recorded", "sender message data")


def recordedConversation():
    """The messages of data/py_client.txt, in order."""
    conversation = []
    with open(os.path.join(HERE, "data", "py_client.txt"), encoding="ascii") as file:
        for line in file:
            if line.startswith("#"):
                continue
            sender, text = line.split()
            data = bytes.fromhex(text)
            (message,) = Splitter().feed(data)
            conversation.append(Recorded(sender, message, data))
    return conversation


def findRecorded(sender, kind, action, nth=0):
    """The nth recorded message of that sender, kind and action."""
    return [entry.message for entry in recordedConversation()
            if (entry.sender, entry.message.kind, entry.message.action) == (sender, kind, action)
            ][nth]


class Server:
    """One listening socket on loopback; answers each message with what `reply(message)` returns,
    a list of messages or bytes. Closes the connection when that is None."""

    def __init__(self, reply):
        self.received = []
        self._reply = reply
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._connections = []
        self.port = self._listener.getsockname()[1]
        self.address = "tcp://127.0.0.1:%d" % self.port
        self._accepting = threading.Thread(target=self._accept, daemon=True)
        self._accepting.start()

    def close(self):
        try:
            self._listener.shutdown(socket.SHUT_RDWR)  # ends the accept() under way
        except OSError:
            return  # closed already
        self._accepting.join()
        self._listener.close()
        for connection in self._connections:
            connection.close()

    def _accept(self):
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            self._connections.append(connection)
            threading.Thread(target=self._serve, args=(connection,), daemon=True).start()

    def _serve(self, connection):
        splitter = Splitter()
        try:
            while True:
                data = connection.recv(4096)
                if not data:
                    return
                for message in splitter.feed(data):
                    self.received.append(message)
                    answers = self._reply(message)
                    if answers is None:
                        connection.shutdown(socket.SHUT_RDWR)
                        return
                    for answer in answers:
                        connection.sendall(answer if isinstance(answer, bytes)
                                           else answer.toBytes())
        except OSError:
            return  # the test is over


def answer(request, payload, kind=Kind.REPLY, flags=0):
    return request._replace(kind=kind, payload=payload, flags=flags)


def failure(request, text):
    return answer(request, encode("m", text), Kind.ERROR)


class Replay:
    """Answers as the recorded server did, provided that the request is byte for byte what the
    recorded client sent. Message numbers, links and capabilities are each client's own affair."""

    def __init__(self):
        self._answers = {}
        conversation = recordedConversation()
        for i, entry in enumerate(conversation):
            if entry.sender == "C":
                following = []
                for later in conversation[i + 1:]:
                    if later.sender == "C":
                        break
                    following.append(later.message)
                self._answers.setdefault(_key(entry.message), (entry.message.id, following))

    def __call__(self, request):
        if request.kind == Kind.CANCEL:
            (canceled,) = struct.unpack("<I", request.payload)
            _, following = self._answers[_key(request)]
            return [message._replace(id=canceled) for message in following]
        if _key(request) not in self._answers:
            return [failure(request, "not what the recorded client sent: %r" % (request,))]
        number, following = self._answers[_key(request)]
        return [message._replace(id=request.id) if message.id == number and
                message.kind != Kind.EVENT else message for message in following]


def _key(message):
    opening = message.service == 0
    links = message.action in (0, 1)  # registerEvent, unregisterEvent, and Cancel
    payload = b"" if opening or (links and message.kind == Kind.CANCEL) else message.payload
    if links and payload:
        payload = payload[:8]  # service and signal, without the link
    return (message.kind, message.service, message.object, message.action, payload, message.flags)


__all__ = ["Kind", "Message", "Replay", "Server", "answer", "encode", "failure", "findRecorded",
           "recordedConversation"]
