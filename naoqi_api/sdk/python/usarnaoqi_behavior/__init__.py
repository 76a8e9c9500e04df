"""Runs a Choregraphe behavior with the Python code in its boxes, on a robot at the other end of the
wire: `python3 -m usarnaoqi_behavior behavior.xar --address 127.0.0.1:9559`."""

from .boxes import Behavior
from .project import ProjectError, loadProject

__all__ = ["Behavior", "ProjectError", "loadProject"]
