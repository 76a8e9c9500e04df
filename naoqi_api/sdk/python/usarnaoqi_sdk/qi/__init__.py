"""libqi's Python interface: applications, sessions, futures, signals, services of this program."""

from ..future import Future, FutureState, FutureTimeout, Promise, futureBarrier
from ..signals import Property, Signal
from . import logging, path
from .application import (Application, ApplicationSession, applicationStopped, run, running, stop)
from .logging import Logger, debug, error, fatal, info, verbose, warning
from .objects import DynamicObjectBuilder, Object
from .session import Session
from .tasks import (PeriodicTask, async_, clockNow, runAsync, steadyClockNow, systemClockNow)
from .translator import Translator, tr
from .types import (AnyArguments, AnyValue, Bool, Buffer, Double, Dynamic, Float, Int8, Int16,
                    Int32, Int64, List, Map, Raw, String, Struct, UInt8, UInt16, UInt32, UInt64,
                    Unknown, Void, bind, isinstance_, multiThreaded, nobind, singleThreaded,
                    typeof)

__version__ = "3.1.5"  # of libqi's Python module, whose interface this is

__all__ = [
    "AnyArguments", "AnyValue", "Application", "ApplicationSession", "Bool", "Buffer", "Double",
    "Dynamic", "DynamicObjectBuilder", "Float", "Future", "FutureState", "FutureTimeout", "Int16",
    "Int32", "Int64", "Int8", "List", "Logger", "Map", "Object", "PeriodicTask", "Promise",
    "Property", "Raw", "Session", "Signal", "String", "Struct", "Translator", "UInt16", "UInt32",
    "UInt64", "UInt8", "Unknown", "Void", "applicationStopped", "async_", "bind", "clockNow",
    "debug", "error", "fatal", "futureBarrier", "info", "isinstance_", "logging", "multiThreaded",
    "nobind", "path", "run", "runAsync", "running", "singleThreaded", "steadyClockNow", "stop",
    "systemClockNow", "tr", "typeof", "verbose", "warning"]
