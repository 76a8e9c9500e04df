"""Imports of Python 2 modules: what lies outside Python's own folders is converted first."""

import ast
import importlib.machinery
import importlib.util
import os
import sys
import sysconfig
import tempfile
import tokenize
from importlib.abc import MetaPathFinder
from typing import Any, Dict, Iterator, List, Optional, Tuple

from .translate import Translator

OWN = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Copies:
    """Converts files, and keeps what came out in a folder."""

    def __init__(self, folder: str):
        self._folder = folder
        self._translator = Translator()
        self._count = 0
        self._done: Dict[Tuple[str, int, int], Any] = {}

    @property
    def translator(self) -> Translator:
        return self._translator

    def compiled(self, path: str) -> Any:
        """The code of a source file, whose lines are those of the copy. Raises SyntaxError."""
        now = os.stat(path)
        key = path, now.st_mtime_ns, now.st_size
        if key not in self._done:
            self._done[key] = self._compile(path)
        return self._done[key]

    def _compile(self, path: str) -> Any:
        with tokenize.open(path) if _saysItsEncoding(path) else open(
                path, encoding="utf-8", errors="surrogateescape") as file:
            text = file.read()
        copy = self.write(path, self._translator.toPython3(text, path))
        with open(copy, encoding="utf-8", errors="surrogateescape") as file:
            return compile(file.read(), copy, "exec", dont_inherit=True)

    def write(self, path: str, text: str) -> str:
        """Each in a folder of its own: names may be the same."""
        self._count += 1
        folder = os.path.join(self._folder, str(self._count))
        os.mkdir(folder)
        copy = os.path.join(folder, os.path.basename(path))
        with open(copy, "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(text)
        return copy


def _saysItsEncoding(path: str) -> bool:
    try:
        with open(path, "rb") as file:
            encoding, _ = tokenize.detect_encoding(file.readline)
        with open(path, encoding=encoding) as file:
            file.read()
        return True
    except (SyntaxError, UnicodeDecodeError, LookupError):
        return False


class Loader(importlib.machinery.SourceFileLoader):
    """Of one converted module."""

    def __init__(self, name: str, path: str, copies: Copies):
        super().__init__(name, path)
        self._copies = copies

    def get_code(self, fullname: str) -> Any:
        return self._copies.compiled(self.path)


class Finder(MetaPathFinder):
    """The first of sys.meta_path: takes over what is the user's."""

    def __init__(self, copies: Copies):
        self._copies = copies
        paths = [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
        self._foreign = [os.path.realpath(path) + os.sep for path in paths + [OWN] if path]

    def find_spec(self, name: str, path: Any = None,
                  target: Any = None) -> Optional[importlib.machinery.ModuleSpec]:
        spec = importlib.machinery.PathFinder.find_spec(name, path, target)
        if not spec or not isinstance(spec.loader, importlib.machinery.SourceFileLoader):
            return None
        origin = os.path.realpath(spec.origin or "")
        if self._isForeign(origin):
            return None
        spec.loader = Loader(name, spec.origin or "", self._copies)
        return spec

    def prepare(self, path: str) -> None:
        """Converts what a converted file, and all that it imports, may import: while the program
        runs, that would take its time. Who can not be converted is left for its import to tell."""
        waiting, seen = [path], {path}
        while waiting:
            for name in importedBy(self._copies.compiled(waiting.pop())):
                origin = self._find(name)
                if origin and origin not in seen and self._converts(origin):
                    waiting.append(origin)
                seen.add(origin)

    def _find(self, name: str) -> str:
        """The user's file of a module, or of what it lies in; empty: there is none."""
        places, spec = None, None
        for end in [i for i, letter in enumerate(name + ".") if letter == "."]:
            spec = self.find_spec(name[:end], places)
            places = spec.submodule_search_locations if spec else None
            if places is None:
                break
        return spec.origin or "" if spec else ""

    def _converts(self, path: str) -> bool:
        try:
            self._copies.compiled(path)
        except (OSError, SyntaxError, ValueError):
            return False
        return True

    def _isForeign(self, origin: str) -> bool:
        return any(origin.startswith(folder) for folder in self._foreign) or \
            "/dist-packages/" in origin or "/site-packages/" in origin


def importedBy(code: Any) -> Iterator[str]:
    """The names of modules in the text of a compiled file, wherever they stand in it."""
    with open(code.co_filename, encoding="utf-8", errors="surrogateescape") as file:
        tree = ast.parse(file.read())
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module


_current: List[Copies] = []
_folders: List[tempfile.TemporaryDirectory] = []


def current() -> Copies:
    """Those of the program that runs; its own ones for code that is none."""
    if not _current:
        _folders.append(tempfile.TemporaryDirectory(prefix="usarnaoqi-py2-"))
        _current.append(Copies(_folders[-1].name))
    return _current[-1]


def install(copies: Copies, script: str) -> None:
    """From now on imports are the user's of Python 2; what `script` may import is ready."""
    _current.append(copies)
    finder = Finder(copies)
    finder.prepare(script)
    sys.meta_path.insert(0, finder)
