"""One program's recorded calls, sent again."""

import json
import os
import signal
import sys
from dataclasses import dataclass
from typing import Any, Dict, List, NamedTuple

from documented import Documented, misfit

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..",
                                "naoqi_api", "sdk", "python"))

from usarnaoqi_sdk.al import ALProxy  # noqa: E402
from usarnaoqi_sdk import Session  # noqa: E402

# What a robot refuses too, by program and call: faults of the programs.
FAULTS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "faults.txt")
# What belongs to the client's own libraries and never crosses the wire.
LOCAL = {"ALBroker", "ALBroker.shutdown", "Session.connect"}
# Methods whose answer is a name or number that later calls give back.
HANDED_OUT = {"ALVideoDevice.subscribe", "ALVideoDevice.subscribeCamera", "ALAudioPlayer.loadFile",
              "ALVideoDevice.subscribeCameras"}
TAKEN_BACK = {"ALVideoDevice.unsubscribe", "ALVideoDevice.getImageRemote",
              "ALVideoDevice.getImageLocal", "ALVideoDevice.releaseImage",
              "ALVideoDevice.setResolution"}


class Program(NamedTuple):
    id: str
    path: str
    trace: List[list]


def loadPrograms(path: str) -> List[Program]:
    with open(path, encoding="utf-8") as file:
        return [Program(entry["id"], entry["path"], entry["trace"]) for entry in json.load(file)]


def loadFaults() -> Dict[str, str]:
    """{"program call": why} of lines "program call: why"."""
    with open(FAULTS, encoding="utf-8") as file:
        lines = [line.strip().split(": ", 1) for line in file if line[0] not in "#\n"]
    return {where: why for where, why in lines}


class Replay:
    @dataclass
    class Count:
        calls: int = 0
        accepted: int = 0
        typed: int = 0  # accepted and of the documented type
        mistyped: int = 0
        undocumented: int = 0
        faults: int = 0

        def add(self, other: "Replay.Count") -> None:
            for name, value in vars(other).items():
                setattr(self, name, getattr(self, name) + value)

    def __init__(self, address: str, documented: Documented, verbose: bool, patience: int):
        self.complaints: Dict[str, int] = {}  # and how often
        self._patience = patience  # s of wall time for one call
        self._address = address
        self._documented = documented
        self._verbose = verbose
        self._faults = loadFaults()
        self._count = Replay.Count()
        self._modules = Session(address)  # hosts the program's own modules
        self._handle: Any = None          # what the program was last given
        signal.signal(signal.SIGALRM, _giveUp)

    def run(self, program: Program) -> "Replay.Count":
        for number, (name, arguments, _) in enumerate(program.trace):
            if name not in LOCAL:
                self._send(program, number, name, arguments)
        self._modules.close()
        return self._count

    def _send(self, program: Program, number: int, name: str, arguments: list) -> None:
        self._count.calls += 1
        where = "%s %s" % (program.id, name)
        signal.alarm(self._patience)
        try:
            answer = self._call(name, arguments)
        except RuntimeError as error:
            self._refused(where, arguments, " ".join(str(error).split()))
            return
        finally:
            signal.alarm(0)
        self._count.accepted += 1
        if self._verbose:
            self._complain("%d %s%s = %.200r" % (number, name, arguments, answer))
        self._check(where, name, arguments, answer)

    def _complain(self, text: str) -> None:
        self.complaints[text] = self.complaints.get(text, 0) + 1

    def _refused(self, where: str, arguments: list, text: str) -> None:
        known = self._faults.get(where)
        if known:
            self._count.faults += 1
        self._complain("%s%s%.100s: %s" % (
            "fault of the program (%s): " % known if known else "", where, arguments, text))

    def _check(self, where: str, name: str, arguments: list, answer: Any) -> None:
        service, _, method = name.partition(".")
        if method.startswith("post."):
            documented = ["i"]
        else:
            documented = self._documented.returns(service, method, len(arguments))
        wrong = misfit(answer, documented)
        if wrong:
            self._count.mistyped += 1
            self._complain("%s: %.80r is not %s" % (where, answer, wrong))
        elif documented:
            self._count.typed += 1
        else:
            self._count.undocumented += 1

    def _call(self, name: str, arguments: list) -> Any:
        if name == "ALProxy":
            return self._proxy(arguments[0]).call("ping")
        if name == "ALModule":
            return self._host(arguments[0])
        service, method = name.split(".", 1)
        proxy = self._proxy(service)
        if method.startswith("post."):
            return proxy.postCall(method[len("post."):], *arguments)
        if name in TAKEN_BACK and self._handle is not None:
            arguments = [self._handle] + arguments[1:]
        answer = proxy.call(method, *arguments)
        if name in HANDED_OUT:
            self._handle = answer
        return answer

    def _proxy(self, service: str) -> ALProxy:
        host, port = self._address.split(":")
        return ALProxy(service, host, int(port))

    def _host(self, name: str) -> None:
        """Registers a module of the program's, so that events can name it."""
        directory = self._modules.service("ServiceDirectory")
        info = [name, 0, "", os.getpid(), [], "", ""]
        fields = directory.meta.overloads("registerService")[0].arguments.count(",")
        number = directory.call("registerService", tuple(info[:fields]) if fields else info)
        directory.call("serviceReady", number)


def _giveUp(*_: Any) -> None:
    raise RuntimeError("no answer in time")
