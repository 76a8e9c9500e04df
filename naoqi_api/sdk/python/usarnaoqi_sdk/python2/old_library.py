"""What modules of Python's own library had in Python 2, put back as each is loaded."""

import builtins
import collections
import itertools
import sys
import types
from typing import Any, Callable, Dict

TYPES = {"BooleanType": bool, "BufferType": memoryview, "ClassType": type, "ComplexType": complex,
         "DictType": dict, "DictionaryType": dict, "EllipsisType": type(Ellipsis),
         "FloatType": float, "InstanceType": object, "IntType": int, "ListType": list,
         "LongType": int, "NoneType": type(None), "NotImplementedType": type(NotImplemented),
         "ObjectType": object, "SliceType": slice, "StringType": str, "StringTypes": (str,),
         "TupleType": tuple, "TypeType": type, "UnboundMethodType": types.FunctionType,
         "UnicodeType": str, "XRangeType": range}
ITERTOOLS = {"imap": builtins.map, "ifilter": builtins.filter, "izip": builtins.zip,
             "ifilterfalse": itertools.filterfalse, "izip_longest": itertools.zip_longest}


def _add(module: Any, **values: Any) -> None:
    """Unless it is still there."""
    for name, value in values.items():
        if name not in dir(module):
            setattr(module, name, value)


def _string(module: Any) -> None:
    _add(module, letters=module.ascii_letters, lowercase=module.ascii_lowercase,
         uppercase=module.ascii_uppercase, maketrans=str.maketrans, atoi=int, atol=int, atof=float,
         join=_join, joinfields=_join, splitfields=str.split)
    for name in ("capitalize", "center", "count", "expandtabs", "find", "index", "ljust", "lower",
                 "lstrip", "replace", "rfind", "rindex", "rjust", "rstrip", "split", "strip",
                 "swapcase", "translate", "upper", "zfill"):
        _add(module, **{name: getattr(str, name)})


def _join(words: Any, between: str = " ") -> str:
    return between.join(words)


def _sys(module: Any) -> None:
    _add(module, maxint=module.maxsize, exc_clear=lambda: None,
         setcheckinterval=lambda _: None, getcheckinterval=lambda: 100)


def _time(module: Any) -> None:
    _add(module, clock=module.process_time)


def _threading(module: Any) -> None:
    _add(module.Thread, isAlive=module.Thread.is_alive)
    _add(module, _Timer=module.Timer, _Event=module.Event, _sleep=_sleep)


def _sleep(seconds: float) -> None:
    import time
    time.sleep(seconds)


def _collections(module: Any) -> None:
    import collections.abc as abc
    _add(module, **{name: getattr(abc, name) for name in abc.__all__})


def _contextlib(module: Any) -> None:
    @module.contextmanager
    def nested(*managers: Any) -> Any:
        with module.ExitStack() as stack:
            yield tuple(stack.enter_context(manager) for manager in managers)

    _add(module, nested=nested)


def _inspect(module: Any) -> None:
    spec = collections.namedtuple("ArgSpec", "args varargs keywords defaults")
    _add(module, getargspec=lambda function: spec(*module.getfullargspec(function)[:4]))


def _path(module: Any) -> None:
    import os

    def walk(top: str, visit: Callable[[Any, str, list], None], argument: Any) -> None:
        for folder, folders, files in os.walk(top):
            names = folders + files
            visit(argument, folder, names)
            folders[:] = [name for name in folders if name in names]

    _add(module, walk=walk)


def _base64(module: Any) -> None:
    _add(module, encodestring=module.encodebytes, decodestring=module.decodebytes)


def _codecs(module: Any) -> None:
    found = module.getwriter

    def getwriter(encoding: str) -> Any:
        """Of sys.stdout it is what takes bytes that is written to."""
        writer = found(encoding)
        return lambda stream, *rest: writer(getattr(stream, "buffer", stream), *rest)

    module.getwriter = getwriter


def _fractions(module: Any) -> None:
    import math
    _add(module, gcd=math.gcd)


def _cgi(module: Any) -> None:
    import html
    _add(module, escape=lambda text, quote=False: html.escape(text, quote))


def _htmlParser(module: Any) -> None:
    import html
    _add(module.HTMLParser, unescape=lambda self, text: html.unescape(text))


def _platform(module: Any) -> None:
    _add(module, linux_distribution=lambda *_: ("", "", ""), dist=lambda *_: ("", "", ""))


def _image(module: Any) -> None:
    _add(module, fromstring=module.frombytes)
    _add(module.Image, tostring=module.Image.tobytes)


COMPLETED: Dict[str, Callable[[Any], Any]] = {
    "PIL.Image": _image, "base64": _base64, "cgi": _cgi, "codecs": _codecs,
    "collections": _collections, "contextlib": _contextlib, "fractions": _fractions,
    "html.parser": _htmlParser, "inspect": _inspect,
    "itertools": lambda module: _add(module, **ITERTOOLS), "platform": _platform,
    "posixpath": _path, "string": _string, "sys": _sys, "threading": _threading, "time": _time,
    "types": lambda module: _add(module, **TYPES)}


def install() -> None:
    """In what Python has loaded already."""
    for name, complete in COMPLETED.items():
        if name in sys.modules:
            complete(sys.modules[name])


def _module(name: str, **values: Any) -> Any:
    made = types.ModuleType(name)
    made.__dict__.update(values)
    return made


def md5() -> Any:
    import hashlib
    return _module("md5", new=hashlib.md5, md5=hashlib.md5)


def sha() -> Any:
    import hashlib
    return _module("sha", new=hashlib.sha1, sha=hashlib.sha1)


def sets() -> Any:
    return _module("sets", Set=set, ImmutableSet=frozenset)


def new() -> Any:
    return _module("new", classobj=type, code=types.CodeType, function=types.FunctionType,
                   instancemethod=types.MethodType, module=types.ModuleType)


MADE: Dict[str, Callable[[], Any]] = {"md5": md5, "new": new, "sets": sets, "sha": sha}
