"""Objects whose members are given one by one."""

from typing import Any, Callable

from ..bound_types import BIND, Binding
from ..remote_object import RemoteObject
from ..signals import Property, Signal

Object = RemoteObject


class _Members:
    """What a builder has collected; the members are its attributes."""


class DynamicObjectBuilder:
    """Puts an object together for Session.registerService()."""

    def __init__(self) -> None:
        self._members = _Members()

    def advertiseMethod(self, signature: str, function: Callable[..., Any],
                        description: str = "") -> None:
        """`signature` as "name::returns(arguments)" or "name"."""
        name, _, types = signature.partition("::")
        returns, bracket, arguments = types.partition("(")

        def method(*values: Any) -> Any:
            return function(*values)

        method.__doc__ = description
        setattr(method, BIND, Binding(name, returns or "m",
                                      "(" + arguments if bracket else "m"))
        setattr(self._members, name, method)

    def advertiseSignal(self, name: str, signature: str = "m") -> Signal:
        made = Signal(signature)
        setattr(self._members, name, made)
        return made

    def advertiseProperty(self, name: str, signature: str = "m", value: Any = None) -> Property:
        made = Property(signature, value)
        setattr(self._members, name, made)
        return made

    def object(self) -> Any:
        return self._members
