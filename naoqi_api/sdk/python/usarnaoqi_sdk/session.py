"""A session with a robot: opens the connection and finds services by name."""

import functools
import os
import socket
import threading
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Tuple

from .address import DEFAULT_PORT
from .connection import Connection
from .encoding import encode
from .errors import CallError, ConnectionLost, DecodeError
from .hosted import Host, HostedObject
from .remote_object import RemoteObject, fetchObject, readObject
from .signature import parse

CONNECT_TIMEOUT = 5.0  # s
AUTHENTICATE = 8
AUTH_STATE, AUTH_DONE = "__qi_auth_state", 3
SERVICE_DIRECTORY = 1
CREDENTIALS = ("USARNAOQI_USER", "USARNAOQI_TOKEN")
# A capability counts only if both ends have it. Ours are those the package understands.
CAPABILITIES = {"ClientServerSocket": True, "MessageFlags": True, "MetaObjectCache": False,
                "ObjectPtrUID": True, "RelativeEndpointURI": True, "RemoteCancelableCalls": True}


class ServiceInfo(NamedTuple):
    name: str
    id: int
    machine: str
    process: int
    endpoints: List[str]
    session: str
    uid: str = ""  # absent before NAOqi 2.9


class Session:
    """Connected from its construction to close(). Thread-safe. Without a user and a token it says
    those of the environment, USARNAOQI_USER and USARNAOQI_TOKEN, if they are there."""

    def __init__(self, address: str = "127.0.0.1", user: str = "", token: str = ""):
        if not user and not token:
            user, token = (os.environ.get(name, "") for name in CREDENTIALS)
        self._credentials = {"auth_user": user, "auth_token": token} if user or token else {}
        self._lock = threading.Lock()
        self.host = Host()
        self._services: Dict[str, RemoteObject] = {}
        self._address = parseAddress(address)
        self._connections = {self._address: self._open(self._address)}
        self._directory = fetchObject(self._main, SERVICE_DIRECTORY, "ServiceDirectory")
        if "serviceRemoved" in self._directory.meta.signals:
            self._directory.serviceRemoved.connect(lambda _, name: self._forget(name))

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def service(self, name: str) -> RemoteObject:
        """The service `name`. Raises CallError if there is none."""
        if name == "ServiceDirectory":
            return self._directory
        with self._lock:
            known = self._services.get(name)
        if known:
            return known
        info = ServiceInfo(*self._directory.call("service", name))
        found = fetchObject(self._connectionOf(info), info.id, name)
        with self._lock:
            return self._services.setdefault(name, found)

    def services(self) -> List[ServiceInfo]:
        return [ServiceInfo(*fields) for fields in self._directory.call("services")]

    def registerService(self, name: str, target: Any) -> int:
        """Makes `target`, any Python object, a service for everybody: its methods, and those of its
        attributes that are signals and properties. Calls come through the directory's connection.
        Returns its number. Raises CallError if the name is taken."""
        hosted = HostedObject(target, name)
        fields = (name, 0, self._directory.call("machineId"), os.getpid(), [], "0", "")
        (info,) = parse(self._directory.meta.overloads("registerService")[0].arguments).items
        number = self._directory.call("registerService", fields[:len(info.items)])
        self.host.add(number, hosted)
        self._directory.call("serviceReady", number)
        return number

    def unregisterService(self, number: int) -> None:
        name = self.host.remove(number)
        self._directory.call("unregisterService", number)
        self._forget(name)

    def _forget(self, name: str) -> None:
        with self._lock:
            self._services.pop(name, None)

    def whenLost(self, job: Callable[[str], None]) -> None:
        """Calls `job(reason)` once the connection to the directory has ended."""
        self._main.on_lost = job

    def isConnected(self) -> bool:
        return self._main.isOpen()

    def close(self) -> None:
        """Ends the connections; calls still waiting raise ConnectionLost."""
        for connection in list(self._connections.values()):
            connection.close()

    @property
    def _main(self) -> Connection:
        return self._connections[self._address]

    def _connectionOf(self, info: ServiceInfo) -> Connection:
        addresses = reachable(info.endpoints, self._address)
        same_connection = any(text.startswith("qi:") for text in info.endpoints)
        if same_connection or self._address in addresses or not addresses:
            return self._main
        problem: Optional[Exception] = None
        for address in addresses:
            try:
                with self._lock:
                    if address not in self._connections:
                        self._connections[address] = self._open(address)
                    return self._connections[address]
            except ConnectionLost as error:
                problem = error
        raise ConnectionLost("service %s is out of reach: %s" % (info.name, problem))

    def _open(self, address: Tuple[str, int]) -> Connection:
        try:
            sock = socket.create_connection(address, CONNECT_TIMEOUT)
        except OSError as error:
            raise ConnectionLost("Cannot connect to tcp://%s:%d: %s" % (*address, error)) from None
        sock.settimeout(None)
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection = Connection(sock)
        connection.host = self.host
        try:
            self._authenticate(connection)
        except (CallError, DecodeError):
            connection.close()
            raise
        connection.read_object = functools.partial(readObject, connection)
        return connection

    def _authenticate(self, connection: Connection) -> None:
        request = encode("{sm}", {**CAPABILITIES, **self._credentials})
        try:
            answer = connection.call(0, 0, AUTHENTICATE, request, "{sm}").value()
        except CallError:
            if self._credentials:
                raise
            connection.sendCapabilities(CAPABILITIES)  # a server from before authentication
            return
        if answer.pop(AUTH_STATE, None) != AUTH_DONE:
            raise CallError("authentication failed: %s" % answer.get("__qi_auth_err_reason", ""))
        connection.peer_capabilities.update(answer)


def parseAddress(text: str) -> Tuple[str, int]:
    """("host", port) of "[tcp://]host[:port]"."""
    bare = text[6:] if text.startswith("tcp://") else text
    host, colon, port = bare.partition(":")
    if not host or (colon and not port.isdigit()):
        raise ConnectionLost("'%s' is not an address such as tcp://127.0.0.1:9559" % text)
    return host, int(port) if colon else DEFAULT_PORT


def reachable(endpoints: List[str], dialled: Tuple[str, int]) -> List[Tuple[str, int]]:
    """Where a service may be reached, best first: on the host that was dialled, then elsewhere.
    Loopback endpoints are for those who dialled loopback."""
    addresses = [parseAddress(text) for text in endpoints if text.startswith("tcp://")]
    local = _isLoopback(dialled[0])
    addresses = [(dialled[0] if local and _isLoopback(host) else host, port)
                 for host, port in addresses if local or not _isLoopback(host)]
    return sorted(addresses, key=lambda address: address[0] != dialled[0])


def _isLoopback(host: str) -> bool:
    return host == "localhost" or host.startswith("127.")

