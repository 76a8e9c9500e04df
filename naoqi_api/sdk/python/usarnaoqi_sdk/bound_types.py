"""What a Python class says about itself as a service: names and types of its methods, and how many
of them may run at a time."""

import inspect
from typing import Any, Callable, List, NamedTuple, Optional, Tuple

BIND, THREADING = "__qi_bind__", "__qi_threading__"
STANDARD = "_standardMethods"  # of a class whose objects have such before their own
SINGLE, MULTI = "single", "multi"


class Binding(NamedTuple):
    """How a method is offered: None where its Python form decides, `hidden` not at all."""

    name: Optional[str] = None
    returns: Optional[str] = None
    arguments: Optional[str] = None
    hidden: bool = False


class OfferedMethod(NamedTuple):
    name: str
    arguments: str  # the signature of their tuple; "m": any number
    returns: str
    description: str
    function: Callable[..., Any]


def offeredMethods(target: Any) -> List[OfferedMethod]:
    """The methods of `target` that others may call: those whose names do not begin with "_"."""
    found = []
    for name in dir(target):
        if name.startswith("_") or _isAccessor(target, name):
            continue
        function = getattr(target, name, None)
        if callable(function) and not isinstance(function, type) and not _isSignal(function):
            found += _offers(name, function)
    return found


def ownMethods(target: Any, standard: List[OfferedMethod]) -> List[OfferedMethod]:
    """Those that `target` offers beside `standard`: a user's method of the same name counts if it
    takes other arguments."""
    names = {method.name for method in standard}
    signatures = {(method.name, method.arguments) for method in standard}
    return [method for method in offeredMethods(target)
            if method.name not in names or (_isTheUsers(target, method.name) and
                                            (method.name, method.arguments) not in signatures)]


def _isTheUsers(target: Any, name: str) -> bool:
    """Not inherited from a class of this package."""
    owners = [cls.__module__ for cls in type(target).__mro__ if name in vars(cls)]
    return not owners or owners[0].split(".")[0] != __name__.split(".", maxsplit=1)[0]


def _isAccessor(target: Any, name: str) -> bool:
    """A Python property: looking at it would run code."""
    return isinstance(getattr(type(target), name, None), property)


def _isSignal(value: Any) -> bool:
    return hasattr(value, "tupleSignature")


def _offers(name: str, function: Callable[..., Any]) -> List[OfferedMethod]:
    binding = getattr(function, BIND, Binding())
    if binding.hidden:
        return []
    description = inspect.getdoc(function) or ""
    signatures = [binding.arguments] if binding.arguments else _signatures(function)
    return [OfferedMethod(binding.name or name, arguments, binding.returns or "m", description,
                          function) for arguments in signatures]


def _signatures(function: Callable[..., Any]) -> List[str]:
    """One for each number of arguments that the function takes."""
    try:
        least, most = _arity(function)
    except (TypeError, ValueError):  # not to be known, as of functions written in C
        return ["m"]
    if most is None:
        return ["m"]
    return ["(%s)" % ("m" * count) for count in range(least, most + 1)]


def _arity(function: Callable[..., Any]) -> Tuple[int, Optional[int]]:
    least = most = 0
    for parameter in inspect.signature(function).parameters.values():
        if parameter.kind == parameter.VAR_POSITIONAL:
            return least, None
        if parameter.kind in (parameter.POSITIONAL_ONLY, parameter.POSITIONAL_OR_KEYWORD):
            most += 1
            least += parameter.default is parameter.empty
    return least, most
