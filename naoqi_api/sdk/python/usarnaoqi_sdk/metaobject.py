"""What an object offers: its methods, signals and properties, with their numbers and types."""

from typing import Any, Dict, List, NamedTuple, Tuple

from .conversion import convert, fit
from .errors import CallError, ConversionError
from .signature import parse

SIGNATURE = (
    "({I(Issss[(ss)<MetaMethodParameter,name,description>]s)<MetaMethod,uid,returnSignature,name,"
    "parametersSignature,description,parameters,returnDescription>}"
    "{I(Iss)<MetaSignal,uid,name,signature>}{I(Iss)<MetaProperty,uid,name,signature>}s)"
    "<MetaObject,methods,signals,properties,description>")

USER_IDS = 100  # actions below belong to every object


class Method(NamedTuple):
    id: int
    returns: str
    name: str
    arguments: str  # the signature of their tuple, or "m"
    description: str
    parameters: List[Tuple[str, str]]  # name, description
    return_description: str


class Member(NamedTuple):
    """A signal or a property."""

    id: int
    name: str
    signature: str


class MetaObject:
    """Finds the members of an object by name. Immutable."""

    def __init__(self, value: Any):
        self.raw = value  # as it came
        methods, signals, properties, self.description = value
        self.methods = [Method(*fields) for fields in methods.values()]
        self.signals = {member.name: member for member in map(_member, signals.values())}
        self.properties = {member.name: member for member in map(_member, properties.values())}
        self._by_name: Dict[str, List[Method]] = {}
        for method in sorted(self.methods):
            self._by_name.setdefault(method.name, []).append(method)

    def names(self) -> List[str]:
        """The members that are the object's own, hidden ones left out."""
        own = [method.name for method in self.methods if method.id >= USER_IDS]
        own += list(self.signals) + list(self.properties)
        return sorted({name for name in own if not name.startswith("_")})

    def overloads(self, name: str) -> List[Method]:
        return self._by_name.get(name, [])

    def choose(self, name: str, arguments: tuple) -> Method:
        """The overload of `name`, or the exact "name::(signature)". Raises CallError."""
        bare, _, signature = name.partition("::")
        same_name = self.overloads(bare)
        if signature:
            candidates = [method for method in same_name if method.arguments == signature]
        else:
            candidates = [method for method in same_name if _accepts(method, len(arguments))]
        if len(candidates) == 1:
            return candidates[0]
        if candidates:
            return _best(candidates, arguments)
        resolved = signature or "(%s)" % "".join(map(_shortSignature, arguments))
        raise CallError("Can't find method: %s (resolved to '%s')%s" % (
            bare, resolved, _candidates(same_name)))


def _member(fields: tuple) -> Member:
    return Member(*fields)


def _accepts(method: Method, count: int) -> bool:
    return method.arguments == "m" or len(parse(method.arguments).items) == count


def _score(method: Method, arguments: tuple) -> float:
    return fit(parse(method.arguments), arguments)[0]


def _best(candidates: List[Method], arguments: tuple) -> Method:
    scored = sorted(((_score(method, arguments), method) for method in candidates), reverse=True)
    (best, method), (second, _) = scored[:2]
    if best > second:
        return method
    problem = "Ambiguous overload for" if best else "Arguments types did not match for"
    raise CallError("%s %s (resolved to '(%s)')%s" % (
        problem, method.name, "".join(map(_shortSignature, arguments)), _candidates(candidates)))


def _shortSignature(value: Any) -> str:
    for signature in "bdlsrv":  # the natural type of a Python value, where it has one
        score, _ = fit(parse(signature), value)
        if score == 1.0:
            return signature
    return "m"


def _candidates(methods: List[Method]) -> str:
    return "".join("\n  Candidate: %s::%s" % (method.name, method.arguments) for method in methods)


def convertArguments(method: Method, arguments: tuple) -> Any:
    """The arguments in the declared types. Raises ConversionError."""
    if method.arguments == "m":
        return convert("m", arguments)
    types = parse(method.arguments).items
    if len(types) != len(arguments):
        raise ConversionError("%s takes %d arguments, not %d" % (
            method.name, len(types), len(arguments)))
    return convert(method.arguments, arguments)
