"""What modules say of themselves."""

import inspect
from typing import Any, List


class ALDocable:
    """A module's name and descriptions, for who asks it."""

    def __init__(self, bIsModule: bool = False):
        self._is_module = bIsModule
        self._module_description = ""
        self._current_function = ""

    def setModuleDescription(self, text: str) -> None:
        self._module_description = str(text)

    def functionName(self, name: str, *_: str) -> None:
        """The function that is described next."""
        self._current_function = name

    def addParam(self, name: str, description: str = "") -> None:
        """Kept for programs that call it: descriptions come from the docstrings."""

    def setReturn(self, name: str, description: str = "") -> None:
        """Kept for programs that call it."""

    def BIND_PYTHON(self, module: str, method: str, *_: Any) -> None:
        """Kept for programs that call it: every public method is bound."""

    bindPython = BIND_PYTHON

    def getMethodList(self) -> List[str]:
        return sorted(name for name, _ in inspect.getmembers(self, inspect.ismethod)
                      if not name.startswith("_"))

    def getMethodHelp(self, name: str) -> str:
        return inspect.getdoc(getattr(self, name)) or ""

    def getModuleHelp(self) -> str:
        return self._module_description or inspect.getdoc(type(self)) or ""


def autoBind(target: Any, _only_if_documented: bool = False) -> None:
    """Kept for programs that call it: every public method is bound."""
