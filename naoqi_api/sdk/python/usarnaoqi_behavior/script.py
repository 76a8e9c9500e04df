"""The Python code of a box: made from its text, with what Choregraphe's boxes find around them."""

import logging
import re
from typing import Any, Callable, Dict, Optional, Type

from usarnaoqi_sdk.al import ALProxy
from usarnaoqi_sdk import Session
from usarnaoqi_sdk.python2 import aliases, meaning
from usarnaoqi_sdk.python2.loader import current
from usarnaoqi_sdk.python2.translate import NoTranslator


class GeneratedClass:
    """What the class in a box derives from. Its outputs are methods, `self.onStopped(value)`."""

    _box: Any = None  # a boxes.Running

    def __init__(self, *_: Any):
        pass

    def onLoad(self) -> None:
        pass

    def onUnload(self) -> None:
        pass

    @property
    def boxName(self) -> str:
        return self._box.box.name

    @property
    def logger(self) -> logging.Logger:
        return logging.getLogger(self._box.box.name)

    def log(self, text: Any) -> None:
        self.logger.info("%s", text)

    def getName(self) -> str:
        return self._box.box.name

    def getParameter(self, name: str) -> Any:
        return self._box.getParameter(name)

    def setParameter(self, name: str, value: Any) -> None:
        self._box.setParameter(name, value)

    def behaviorAbsolutePath(self) -> str:
        return self._box.behavior.folder

    def session(self) -> Session:
        return self._box.behavior.session


class _LazyProxy:
    """A service that code names without making a proxy, `ALMotion.wakeUp()`: found when used."""

    def __init__(self, name: str, make: Callable[[str], ALProxy]):
        self._name, self._make = name, make
        self._proxy: Optional[ALProxy] = None

    def __getattr__(self, method: str) -> Any:
        if self._proxy is None:
            self._proxy = self._make(self._name)
        return getattr(self._proxy, method)


def makeClass(code: str, place: str, outputs: Dict[str, str],
              makeProxy: Callable[..., ALProxy]) -> Type[GeneratedClass]:
    """The class MyClass of a box's code. Raises whatever the code raises, SyntaxError too."""
    def output(id_: str):
        return lambda self, value=None: self._box.give(id_, value)

    base = type("GeneratedClass", (GeneratedClass,),
                {name: output(id_) for id_, name in outputs.items()})
    names: Dict[str, Any] = {"__name__": "box", "GeneratedClass": base, "ALProxy": makeProxy}
    for name in set(re.findall(r"\bAL[A-Z]\w+", code)) - {"ALProxy"}:
        names[name] = _LazyProxy(name, makeProxy)
    exec(_compile(code + "\n", place, names), names)  # pylint: disable=exec-used
    found = names.get("MyClass")
    if not isinstance(found, type) or not issubclass(found, GeneratedClass):
        raise SyntaxError("%s: expected a class MyClass(GeneratedClass)" % place)
    return found


def _compile(code: str, place: str, names: Dict[str, Any]) -> Any:
    try:
        return compile(code, place, "exec")
    except SyntaxError:
        translated = _fromPython2(code, names)
        if translated is None:
            raise
        return compile(translated, place, "exec")


def _fromPython2(code: str, names: Dict[str, Any]) -> Optional[str]:
    """As Python 3, and what its words meant among `names`; None for what is no Python 2 either, and
    where nothing translates."""
    try:
        translated = current().translator.toPart(code, "box")
    except (NoTranslator, SyntaxError):  # the first SyntaxError says it better
        return None
    aliases.install()
    names.update({name: getattr(meaning, name) for name in meaning.__all__})
    return translated
