"""qi.logging: lines by category, to the standard error."""

import sys
import threading
import time
from typing import Any, Dict, List, Tuple

__all__ = ["DEBUG", "ERROR", "FATAL", "INFO", "Logger", "SILENT", "VERBOSE", "WARNING",
           "addFilter", "debug", "error", "fatal", "info", "logDebug", "logError", "logFatal",
           "logInfo", "logVerbose", "logWarning", "setContext", "setFilters", "setLevel", "verbose",
           "warning"]

SILENT, FATAL, ERROR, WARNING, INFO, VERBOSE, DEBUG = range(7)
_LETTERS = "SFEWIVD"

_lock = threading.Lock()
_filters: List[Tuple[str, int]] = [("*", INFO)]


def setLevel(level: int) -> None:
    """What is less important than `level` is not shown."""
    _filters[:] = [("*", level)]


def setFilters(rules: str) -> None:
    """Rules such as "*=INFO:qi.*=WARNING" or "+my.category:-noisy.*"; the last that fits counts."""
    for rule in rules.split(":"):
        category, _, level = rule.lstrip("+-").partition("=")
        wanted = {"+": DEBUG, "-": SILENT}.get(rule[:1], INFO)
        addFilter(category, _level(level) if level else wanted)


def addFilter(category: str, level: int) -> None:
    _filters.append((category, level))


def setContext(_context: int) -> None:
    """Lines have their time, level and category, whatever is asked."""


class Logger:
    """Lines of one category."""

    def __init__(self, category: str):
        self.category = category

    def log(self, level: int, *words: Any) -> None:
        if level > _levelOf(self.category):
            return
        text = " ".join(map(str, words))
        stamp = time.strftime("%H:%M:%S")
        with _lock:
            sys.stderr.write("[%s] %s %s: %s\n" % (_LETTERS[level], stamp, self.category, text))

    def fatal(self, *words: Any) -> None:
        self.log(FATAL, *words)

    def error(self, *words: Any) -> None:
        self.log(ERROR, *words)

    def warning(self, *words: Any) -> None:
        self.log(WARNING, *words)

    def info(self, *words: Any) -> None:
        self.log(INFO, *words)

    def verbose(self, *words: Any) -> None:
        self.log(VERBOSE, *words)

    def debug(self, *words: Any) -> None:
        self.log(DEBUG, *words)


def _levelOf(category: str) -> int:
    level = INFO
    for pattern, wanted in _filters:
        if pattern == category or pattern.endswith("*") and category.startswith(pattern[:-1]):
            level = wanted
    return level


def _level(text: str) -> int:
    names: Dict[str, int] = {name: level for level, name in enumerate(
        ("SILENT", "FATAL", "ERROR", "WARNING", "INFO", "VERBOSE", "DEBUG"))}
    return int(text) if text.isdigit() else names.get(text.upper(), INFO)


def fatal(category: str, *words: Any) -> None:
    Logger(category).fatal(*words)


def error(category: str, *words: Any) -> None:
    Logger(category).error(*words)


def warning(category: str, *words: Any) -> None:
    Logger(category).warning(*words)


def info(category: str, *words: Any) -> None:
    Logger(category).info(*words)


def verbose(category: str, *words: Any) -> None:
    Logger(category).verbose(*words)


def debug(category: str, *words: Any) -> None:
    Logger(category).debug(*words)


logFatal, logError, logWarning = fatal, error, warning
logInfo, logVerbose, logDebug = info, verbose, debug
