"""qi.Translator: texts stay as they are, as there are no dictionaries here."""

from typing import Optional


class Translator:
    """Translates nothing."""

    def __init__(self, name: str):
        self._name = name

    def setDefaultDomain(self, _domain: str) -> None:
        """Kept for programs that call it."""

    def setCurrentLocale(self, _locale: str) -> None:
        """Kept for programs that call it."""

    def addDomain(self, _domain: str) -> None:
        """Kept for programs that call it."""

    def translate(self, text: str, _domain: str = "", _locale: Optional[str] = None,
                  _context: str = "") -> str:
        return text


def tr(text: str, _domain: str = "", _locale: Optional[str] = None) -> str:
    return text
