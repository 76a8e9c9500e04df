"""A client for a Nao's services, over the robot's own wire (qi messaging), in pure Python.

    from usarnaoqi_sdk import Session

    with Session("tcp://127.0.0.1:9559") as session:
        motion = session.service("ALMotion")
        motion.setAngles("HeadYaw", 0.5, 0.1)

The modules `naoqi`, `qi`, `almath`, `motion` and `vision_definitions`, which finder.py offers, have
the same under the names that programs use.
"""

import importlib
from typing import Any

_HOMES = {"CallError": "errors", "ConnectionLost": "errors", "ConversionError": "errors",
          "DecodeError": "errors", "QiError": "errors", "Future": "future", "Promise": "future",
          "Property": "signals", "RemoteObject": "remote_object", "Session": "session",
          "Signal": "signals"}

__all__ = sorted(_HOMES)


def __getattr__(name: str) -> Any:
    """Loads what is asked for: the finder, which every start of Python loads, stays light."""
    if name not in _HOMES:
        raise AttributeError("module '%s' has no attribute '%s'" % (__name__, name))
    return getattr(importlib.import_module("." + _HOMES[name], __name__), name)
