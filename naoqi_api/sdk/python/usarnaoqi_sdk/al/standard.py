"""The methods 100 to 112 of every NaoQi module, for one that lives in this program: what `.post`
begins (`__pCall`, `wait`, `isRunning`, `stop`), and what tells of the others."""

import itertools
import sys
import threading
from typing import Any, Callable, Dict, List, Optional

from ..bound_types import OfferedMethod
from ..conversion import convert
from ..errors import CallError
from ..future import Future
from ..signature import parse

Methods = Dict[int, OfferedMethod]


class _Task:
    """One posted call; it lasts as long as the future that its method returns, if it does."""

    def __init__(self) -> None:
        self.over = threading.Event()
        self.future: Optional[Future] = None

    def run(self, function: Callable[[], Any]) -> None:
        result = function()
        if isinstance(result, Future):
            self.future = result
            result.value()


class Tasks:
    """Calls that nobody waits for at first, each on a thread of its own."""

    def __init__(self) -> None:
        self._numbers = itertools.count(1)
        self._running: Dict[int, _Task] = {}

    def start(self, name: str, function: Callable[[], Any]) -> int:
        number, task = next(self._numbers), _Task()
        self._running[number] = task

        def run() -> None:
            try:
                task.run(function)
            except Exception as error:  # pylint: disable=broad-except  # nobody asks how it ended
                sys.stderr.write("%s: %s\n" % (name, error))
            finally:
                self._running.pop(number, None)
                task.over.set()

        threading.Thread(target=run, name=name, daemon=True).start()
        return number

    def wait(self, number: int, timeout_ms: int) -> bool:
        """True if the time-out [ms] came first; 0: no limit."""
        task = self._running.get(number)
        limit = timeout_ms / 1000 if timeout_ms > 0 else None
        return task is not None and not task.over.wait(limit)

    def isRunning(self, number: int) -> bool:
        return number in self._running

    def stop(self, number: int) -> None:
        """Cancels a future; Python code that runs is not to be stopped. Raises CallError."""
        task = self._running.get(number)
        if not task:
            return
        if not task.future or not task.future.isCancelable():
            raise CallError("a method that runs can not be stopped")
        task.future.cancel()


class StandardMethods:
    """`methods`: all that the module offers, these included, by their numbers."""

    def __init__(self, module: Any, methods: Methods):
        self._module, self._methods, self._tasks = module, methods, Tasks()

    def offered(self) -> List[OfferedMethod]:
        """In their order from number 100 on."""
        module = self._module
        table = (("exit", "()", "v", "Ends the module; not for others.", self._exit),
                 ("__pCall", "(I[m])", "i", "Starts a method without waiting for it: .post.",
                  self._post),
                 ("pCall", "(m)", "m", "Calls a method by name or number.", self._callNow),
                 ("version", "()", "s", "The module's version.", module.version),
                 ("ping", "()", "b", "Always true.", module.ping),
                 ("getMethodList", "()", "[s]", "The names of the methods.", self._names),
                 ("getMethodHelp", "(s)", "m", "What a method does.", self._help),
                 ("getModuleHelp", "()", "m", "What the module is for.", self._moduleHelp),
                 ("wait", "(ii)", "b", "Waits for a posted call; true if the time-out came first.",
                  self._tasks.wait),
                 ("isRunning", "(i)", "b", "Whether a posted call has not ended.",
                  self._tasks.isRunning),
                 ("stop", "(i)", "v", "Stops a posted call, if it can be stopped.",
                  self._tasks.stop),
                 ("getBrokerName", "()", "s", "The name of the broker.", module.getBrokerName),
                 ("getUsage", "(s)", "s", "One line on a method.", self._usage))
        return [OfferedMethod(*row) for row in table]

    def _exit(self) -> None:
        raise CallError("a client can not end a module")

    def _post(self, uid: int, arguments: List[Any]) -> int:
        method = self._methods.get(uid)
        if not method:
            raise CallError("no method has the id %d" % uid)
        return self._tasks.start(method.name, _call(method, arguments))

    def _callNow(self, call: Any) -> Any:
        if not isinstance(call, (list, tuple)) or not call:
            raise CallError("expected [method, arguments...]")
        uid, arguments = call[0], list(call[1:])
        for method in [self._methods[uid]] if uid in self._methods else self._named(uid):
            if method.arguments == "m" or len(arguments) == _count(method):
                return _call(method, arguments)()
        raise CallError("no method %s takes %d arguments" % (uid, len(arguments)))

    def _named(self, name: Any) -> List[OfferedMethod]:
        found = [method for method in self._methods.values() if method.name == name]
        if not found:
            raise CallError("no method has the name %s" % name)
        return found

    def _names(self) -> List[str]:
        return sorted({method.name for method in self._methods.values()})

    def _help(self, name: str) -> List[str]:
        return [name, self._named(name)[0].description]

    def _moduleHelp(self) -> List[str]:
        return [self._module.getName(), self._module.getModuleHelp()]

    def _usage(self, name: str) -> str:
        method = self._named(name)[0]
        return "%s%s -> %s: %s" % (name, method.arguments, method.returns, method.description)


def _count(method: OfferedMethod) -> int:
    return len(parse(method.arguments).items)


def _call(method: OfferedMethod, arguments: List[Any]) -> Callable[[], Any]:
    """Raises CallError at once if the arguments do not fit."""
    fitting = arguments if method.arguments == "m" else convert(method.arguments, tuple(arguments))
    return lambda: method.function(*fitting)
