"""Aldebaran's client module, over the same wire: programs written for a Nao run unchanged.

    from naoqi import ALProxy
    motion = ALProxy("ALMotion", "127.0.0.1", 9559)
    task = motion.post.moveTo(0.3, 0.0, 0.0)   # returns at once
    motion.wait(task, 0)
"""

from usarnaoqi_sdk.al import (ALBehavior, ALBroker, ALDocable, ALModule, ALProxy, autoBind,
                              createModule)

__all__ = ["ALBehavior", "ALBroker", "ALDocable", "ALModule", "ALProxy", "autoBind",
           "createModule"]


def __getattr__(name):
    """`from naoqi import motion`: the modules beside this one, found as others find them."""
    if name in ("almath", "motion", "vision_definitions"):
        import importlib
        return importlib.import_module(name)
    raise AttributeError("module 'naoqi' has no attribute '%s'" % name)
