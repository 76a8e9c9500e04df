"""The types of libqi as names, and the decorators that say how a class becomes a service."""

from typing import Any, Callable, Optional

from ..bound_types import BIND, MULTI, SINGLE, THREADING, Binding
from ..encoding import signatureOf
from ..errors import ConversionError


class Type:
    """A type; its text is its signature."""

    def __init__(self, signature: str):
        self.signature = signature

    def __str__(self):
        return self.signature

    def __repr__(self):
        return "qi.Type(%r)" % self.signature

    def __eq__(self, other: Any):
        return isinstance(other, Type) and other.signature == self.signature

    def __hash__(self):
        return hash(self.signature)

    def __call__(self) -> "Type":
        return self  # written with or without parentheses


Void, Bool, String, Raw, Object = Type("v"), Type("b"), Type("s"), Type("r"), Type("o")
Int8, Int16, Int32, Int64 = Type("c"), Type("w"), Type("i"), Type("l")
UInt8, UInt16, UInt32, UInt64 = Type("C"), Type("W"), Type("I"), Type("L")
Float, Double = Type("f"), Type("d")
Dynamic = AnyValue = Type("m")
Unknown, Buffer = Type("X"), Raw


def List(item: Type) -> Type:
    return Type("[%s]" % item)


def Map(key: Type, value: Type) -> Type:
    return Type("{%s%s}" % (key, value))


def Struct(fields: Any) -> Type:
    return Type("(%s)" % "".join(map(str, fields)))


class AnyArguments:
    """As `paramsType`: the method takes any number of arguments."""


def bind(returnType: Any = None, paramsType: Any = None,
         methodName: Optional[str] = None) -> Callable[[Any], Any]:
    """Says a method's types, and its name, where they are not to be those of its Python form."""
    returns = None if returnType is None else str(returnType)
    arguments = _arguments(paramsType)

    def decorate(function: Any) -> Any:
        setattr(function, BIND, Binding(methodName, returns, arguments))
        return function

    return decorate


def _arguments(wanted: Any) -> Optional[str]:
    if wanted is None:
        return None
    if wanted is AnyArguments or isinstance(wanted, AnyArguments):
        return "m"
    return "(%s)" % "".join(map(str, wanted))


def nobind(function: Any) -> Any:
    """The method is not offered to others."""
    setattr(function, BIND, Binding(hidden=True))
    return function


def singleThreaded(*_: Any) -> Callable[[type], type]:
    """A class whose methods are called one at a time; so are those of a class that says nothing."""
    return _threading(SINGLE)


def multiThreaded(*_: Any) -> Callable[[type], type]:
    """A class whose methods may be called at the same time."""
    return _threading(MULTI)


def _threading(kind: str) -> Callable[[type], type]:
    def decorate(cls: type) -> type:
        setattr(cls, THREADING, kind)
        return cls
    return decorate


def typeof(value: Any) -> Type:
    """The type with which `value` travels. Raises TypeError if it can not."""
    try:
        return Type(signatureOf(value))
    except ConversionError as error:
        raise TypeError(str(error)) from None


def isinstance_(value: Any, kind: Type) -> bool:
    """Whether `value` travels as `kind`."""
    try:
        return typeof(value) == kind
    except TypeError:
        return False
