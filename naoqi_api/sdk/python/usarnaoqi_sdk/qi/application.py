"""qi.Application: the options of the command line, a session, and a wait for the end."""

import signal
import sys
import threading
from typing import Any, Callable, List, Optional

from .session import Session

_stopped = threading.Event()
_at_stop: List[Callable[[], Any]] = []
URL_OPTIONS = ("--qi-url",)
OTHER_OPTIONS = ("--qi-listen-url", "--qi-standalone", "--qi-log-level", "--qi-log-filters",
                 "--qi-log-context")
FLAGS = ("--qi-standalone",)


class Application:
    """Takes `--qi-url` and its kin from the arguments (sys.argv unless told otherwise).

        app = qi.Application(sys.argv)
        app.start()                        # connects
        app.session.service("ALMotion")
        app.run()                          # until stop(), Ctrl-C or the session's end
    """

    def __init__(self, args: Optional[List[str]] = None, raw: bool = False,
                 autoExit: bool = True, url: Optional[str] = None):
        own = sys.argv if args is None else args
        found = None if raw else _takeOptions(own)
        self.url = found or url or "tcp://127.0.0.1:9559"
        self.session = Session()
        self.autoExit = autoExit
        self._started = False
        _stopped.clear()

    def start(self) -> None:
        """Raises RuntimeError if nobody answers."""
        if not self._started:
            self.session.connect(self.url)
            if self.autoExit:
                self.session.disconnected.connect(lambda _: stop())
            self._started = True

    def run(self) -> None:
        self.start()
        run()

    @staticmethod
    def stop() -> None:
        stop()

    def atRun(self, function: Callable[[], Any]) -> None:
        """Called now: what an application does before run() is up to it."""
        function()

    @staticmethod
    def atStop(function: Callable[[], Any]) -> None:
        _at_stop.append(function)


ApplicationSession = Application


def _takeOptions(arguments: List[str]) -> Optional[str]:
    """The URL among the arguments; they lose what is ours."""
    found, kept, words = None, [], iter(list(arguments))
    for word in words:
        name, equals, value = word.partition("=")
        if name not in URL_OPTIONS + OTHER_OPTIONS:
            kept.append(word)
            continue
        if not equals and name not in FLAGS:
            value = next(words, "")
        if name in URL_OPTIONS:
            found = value
    arguments[:] = kept
    return found


def run() -> None:
    """Waits until stop() or Ctrl-C."""
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        while not _stopped.wait(3600):
            pass
    except KeyboardInterrupt:
        stop()


def stop() -> None:
    """Ends run()."""
    if not _stopped.is_set():
        _stopped.set()
        for function in _at_stop:
            function()


def running() -> bool:
    return not _stopped.is_set()


def applicationStopped() -> bool:
    return _stopped.is_set()
