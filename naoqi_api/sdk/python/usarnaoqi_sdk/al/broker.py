"""A broker: this program's place among the robot's modules."""

import threading
from typing import Any, Dict, List, Optional

from ..address import address, split
from ..errors import ConnectionLost, QiError
from ..session import Session

_lock = threading.Lock()
_sessions: Dict[str, Session] = {}
_brokers: List["ALBroker"] = []


def sessionAt(where: str) -> Session:
    """The session with that address; one for the whole program. Raises ConnectionLost."""
    with _lock:
        session = _sessions.get(where)
        if not session or not session.isConnected():
            session = _sessions[where] = Session(where)
        return session


def currentBroker() -> Optional["ALBroker"]:
    """The one made last, which modules and proxies without an address use."""
    return _brokers[-1] if _brokers else None


class ALBroker:
    """Connects to the robot at `parent_ip`; modules made afterwards are known there. The address to
    listen on, `ip` and `port`, is not needed: calls come back over the connection made here."""

    def __init__(self, name: str, ip: str = "0.0.0.0", port: int = 0,
                 parent_ip: Optional[str] = None, parent_port: Optional[int] = None, *_: Any):
        self._name = str(name)
        self._address = address(parent_ip or ip, parent_port)
        try:
            self.session = sessionAt(self._address)
        except ConnectionLost:
            raise RuntimeError("\tALBroker::createBroker\n\tCannot connect to tcp://%s" %
                               self._address) from None
        self._modules: List[Any] = []
        _brokers.append(self)

    def getName(self) -> str:
        return self._name

    def getParentIP(self) -> str:
        return split(self._address)[0]

    def getParentPort(self) -> int:
        return split(self._address)[1]

    def getParentBroker(self) -> "ALBroker":
        return self

    def getIP(self) -> str:
        return "127.0.0.1"

    def getPort(self) -> int:
        """0: nothing listens here."""
        return 0

    def getModuleList(self) -> List[str]:
        return [module.getName() for module in self._modules]

    def getGlobalModuleList(self) -> List[str]:
        return [info.name for info in self.session.services()]

    def isModulePresent(self, name: str) -> bool:
        return name in self.getGlobalModuleList()

    def getProxy(self, name: str) -> Any:
        from .proxy import ALProxy
        return ALProxy(name, self)

    createProxy = getProxy

    def adopt(self, module: Any) -> None:
        """A module of this broker: leaves with it."""
        self._modules.append(module)

    def shutdown(self) -> None:
        """Its modules are no longer known to the robot; proxies stay."""
        modules, self._modules = self._modules, []
        for module in modules:
            try:
                module.exit()
            except QiError:
                pass  # gone with its robot
        if self in _brokers:
            _brokers.remove(self)
