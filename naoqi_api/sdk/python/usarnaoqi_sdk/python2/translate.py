"""Python 2 text to Python 3, by lib2to3 or fissix, whichever there is."""

import re
import warnings
from typing import Any, List

from . import global_names, operators

# A script's folder is no package, whatever else lies in it: imports stay absolute. The others'
# words are defined, by meaning.py and old_library.py.
UNWANTED = frozenset({"import", "reload", "map", "filter", "zip", "execfile", "itertools",
                      "itertools_imports", "types"})
PRELUDE = "from usarnaoqi_sdk.python2.meaning import *; "


class NoTranslator(RuntimeError):
    """This Python has neither lib2to3 nor fissix."""


class Translator:
    """Thread-safe after construction, as long as one text is translated at a time."""

    def __init__(self) -> None:
        self._name, refactor = _load()
        fixers = [name for name in refactor.get_fixers_from_package(self._name + ".fixes")
                  if name.rpartition("fix_")[2] not in UNWANTED]
        self._tool = _quiet(refactor.RefactoringTool)(fixers, {"print_function": False})
        self._with_print_function = _quiet(refactor.RefactoringTool)(
            [name for name in fixers if not name.endswith("fix_print")], {"print_function": True})

    @property
    def name(self) -> str:
        return self._name

    def toPython3(self, text: str, place: str) -> str:
        """A module. Raises SyntaxError, with the line, for what is no Python 2 either."""
        return global_names.moved(_withPrelude(self._translated(text, place)))

    def toPart(self, text: str, place: str) -> str:
        """The same, for who gives it the names of meaning.py."""
        return global_names.moved(self._translated(text, place))

    def _translated(self, text: str, place: str) -> str:
        text = text if text.endswith("\n") else text + "\n"
        try:
            tree = self._refactorIndented(text, place)
        except Exception as error:  # pylint: disable=broad-except  # of two libraries' own kinds
            line = getattr(error, "context", ("", (1, 0)))[1][0]
            raise SyntaxError("%s:%d: neither Python 3 nor Python 2" % (place, line)) from None
        return _asPython2(operators.translated(tree, text))

    def _refactorIndented(self, text: str, place: str) -> Any:
        """Python 2 took a tab for 8 columns; where that makes no sense, an editor's 4 are meant."""
        try:
            return self._refactor(_withoutTabs(text, 8), place)
        except Exception as error:  # pylint: disable=broad-except
            if "\t" not in text:
                raise
            try:
                return self._refactor(_withoutTabs(text, 4), place)
            except Exception:  # pylint: disable=broad-except
                raise error from None  # the first one's place is the better one

    def _refactor(self, text: str, place: str) -> Any:
        first, second = self._tool, self._with_print_function
        if "print_function" in text:
            first, second = second, first
        try:
            return first.refactor_string(text, place)
        except Exception as error:  # pylint: disable=broad-except
            try:  # print as a function, used without its import
                return second.refactor_string(text, place)
            except Exception:  # pylint: disable=broad-except
                raise error from None  # the first one's place is the better one


def _load() -> Any:
    for name in ("lib2to3", "fissix"):
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                import importlib
                return name, importlib.import_module(name + ".refactor")
        except ImportError:
            continue
    raise NoTranslator("this Python has no lib2to3 (it went with 3.13); install fissix, or run the "
                       "program with an older Python 3")


def _quiet(tool: Any) -> Any:
    """What the tool would tell of each file is told nowhere."""
    class Quiet(tool):
        def log_message(self, *_: Any) -> None:
            pass

        def log_debug(self, *_: Any) -> None:
            pass

        def log_error(self, *_: Any, **__: Any) -> None:
            raise

    return Quiet


def _asPython2(text: str) -> str:
    """Who asks for the version is told Python 2's: the branches for it are what was converted.
    Caught errors have a message and are lists."""
    for name in set(re.findall(r"\bexcept\b[^:\n]* as (\w+)\s*:", text)):
        text = re.sub(r"(?<![\w.])%s\.message\b(?!\s*[-+*/]?=[^=])" % name,
                      "py2_message(%s)" % name, text)
        text = re.sub(r"(?<![\w.])%s(?=\[\d+\])" % name, "py2_items(%s)" % name, text)
    return re.sub(r"\bsys\.version_info\b", "py2_version_info", text)


def _withoutTabs(text: str, columns: int) -> str:
    """Tabs in front of lines as blanks: Python 2 let both be mixed."""
    lines = []
    for line in text.split("\n"):
        rest = line.lstrip(" \t")
        lines.append(line[:len(line) - len(rest)].expandtabs(columns) + rest)
    return "\n".join(lines)


def _withPrelude(text: str) -> str:
    """The prelude in front of the first statement that may have one, so that lines keep their
    numbers; before that come comments, the docstring and what is imported of the future."""
    import ast
    lines: List[str] = text.split("\n")
    body = ast.parse(text).body
    for at, node in enumerate(body):
        is_docstring = at == 0 and isinstance(node, ast.Expr) and isinstance(
            getattr(node, "value", None), ast.Constant)
        is_future = isinstance(node, ast.ImportFrom) and node.module == "__future__"
        if is_docstring or is_future:
            continue
        line = min([node.lineno] + [d.lineno for d in getattr(node, "decorator_list", [])])
        if _mayFollow(lines[line - 1]):
            lines[line - 1] = PRELUDE + lines[line - 1]
            return "\n".join(lines)
        lines[line - 1] = PRELUDE.rstrip("; ") + "\n" + lines[line - 1]
        return "\n".join(lines)
    return text


def _mayFollow(line: str) -> bool:
    """Whether a statement fits in front of it: not of those that open a block, nor a decorator."""
    words = line.replace("(", " ").replace(":", " ").split()
    return bool(words) and words[0] not in {
        "def", "class", "if", "for", "while", "try", "with", "async"} and not line.startswith("@")
