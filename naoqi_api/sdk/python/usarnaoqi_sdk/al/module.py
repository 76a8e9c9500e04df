"""Modules that live in this program: the robot calls their methods, above all as events."""

import time
from typing import Any, List, Optional

from ..address import address
from ..bound_types import MULTI, OfferedMethod
from ..errors import CallError, ConnectionLost
from .broker import ALBroker, currentBroker, sessionAt
from .docable import ALDocable
from .proxy import ALProxy
from .standard import Methods, StandardMethods


class ALModule(ALDocable):
    """A service of the robot whose methods are those of the class that derives from it. Calls may
    overlap, each on a thread of its own, as in NaoQi. Needs an ALBroker, or takes the address of
    the environment."""

    __qi_threading__ = MULTI

    def __init__(self, name: str, broker: Optional[ALBroker] = None, *_: Any):
        ALDocable.__init__(self, True)
        self._module_name = str(name)
        self._broker = broker if isinstance(broker, ALBroker) else currentBroker()
        try:
            self._session = self._broker.session if self._broker else sessionAt(address())
            self._service = self._session.registerService(self._module_name, self)
        except ConnectionLost as error:
            raise RuntimeError("\tALModule::ALModule\n\t%s" % error) from None
        except CallError as error:
            raise RuntimeError("\tALModule::ALModule\n\t%s" % error) from None
        if self._broker:
            self._broker.adopt(self)

    def _standardMethods(self, methods: Methods) -> List[OfferedMethod]:
        """What every module offers before its own methods; `methods`: all of them, once known."""
        return StandardMethods(self, methods).offered()

    @property
    def name(self) -> str:
        return self._module_name

    def getName(self) -> str:
        return self._module_name

    def getBrokerName(self) -> str:
        return self._broker.getName() if self._broker else ""

    def getParentBroker(self) -> Optional[ALBroker]:
        return self._broker

    def version(self) -> str:
        return "0"

    def ping(self) -> bool:
        return True

    def exit(self) -> None:
        """The robot forgets the module."""
        service, self._service = self._service, 0
        if service and self._session.isConnected():
            self._session.unregisterService(service)

    def log(self, text: Any) -> None:
        print("[%s] %s" % (self._module_name, text))


class ALBehavior(ALModule):
    """The base of behaviors that are modules: inputs and outputs as methods."""

    def __init__(self, name: str, *arguments: Any):
        ALModule.__init__(self, name, *arguments)
        self.resource = False
        self.hasFinished = False
        self._started = time.monotonic()

    def onLoad(self, *_: Any) -> None:
        """Called once; meant to be replaced."""

    def onUnload(self, *_: Any) -> None:
        """Called at the end; meant to be replaced."""

    def waitResources(self, *_: Any) -> None:
        """Nobody else holds what a behavior needs here."""

    def releaseResource(self, *_: Any) -> None:
        """The counterpart of waitResources()."""


def createModule(name: str) -> Any:
    """A proxy to the module `name`."""
    return ALProxy(name)
