"""What the documentation says methods return: tables Service.csv."""

import csv
import os
from typing import Any, Dict, List, Optional, Tuple


class Documented:
    """The return signatures of every method, by service, name and number of arguments."""

    def __init__(self, folder: str):
        self._folder = folder
        self._services: Dict[str, Dict[Tuple[str, int], List[str]]] = {}

    def returns(self, service: str, method: str, count: int) -> List[str]:
        """All that are documented; none if the method is not."""
        if service not in self._services:
            self._services[service] = self._load(service)
        return self._services[service].get((method, count), [])

    def _load(self, service: str) -> Dict[Tuple[str, int], List[str]]:
        path = os.path.join(self._folder, service + ".csv")
        table: Dict[Tuple[str, int], List[str]] = {}
        if not os.path.exists(path):
            return table
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                key = row["method"], len(items(row["qi_args"][1:-1]))
                table.setdefault(key, []).append(row["qi_return"])
        return table


def items(signature: str) -> List[str]:
    """The members of a tuple's inside: "s[f]m" is s, [f], m."""
    found, depth, start = [], 0, 0
    for end, letter in enumerate(signature):
        depth += (letter in "([{") - (letter in ")]}")
        if depth == 0:
            found.append(signature[start:end + 1])
            start = end + 1
    return found


def fits(value: Any, signature: str) -> bool:
    """Whether what a client got is of that type."""
    kind = signature[:1]
    if kind == "m":
        return True
    if kind == "v":
        return value is None
    if kind == "b":
        return isinstance(value, bool)
    if kind in "cCwWiIlL":
        return isinstance(value, int) and not isinstance(value, bool)
    if kind in "fd":
        return isinstance(value, float)
    if kind == "s":
        return isinstance(value, str)
    if kind == "r":
        return isinstance(value, (bytes, bytearray))
    if kind == "[":
        return isinstance(value, list) and all(fits(item, signature[1:-1]) for item in value)
    if kind == "(":
        members = items(signature[1:-1])
        return len(value) == len(members) and all(map(fits, value, members))
    return value is not None


def misfit(value: Any, documented: List[str]) -> Optional[str]:
    """What was documented, if the value is none of it."""
    if not documented or any(fits(value, signature) for signature in documented):
        return None
    return " or ".join(documented)
