"""Aldebaran's `naoqi` module: proxies, brokers, modules."""

from .broker import ALBroker
from .docable import ALDocable, autoBind
from .module import ALBehavior, ALModule, createModule
from .proxy import ALProxy

__all__ = ["ALBehavior", "ALBroker", "ALDocable", "ALModule", "ALProxy", "autoBind",
           "createModule"]
