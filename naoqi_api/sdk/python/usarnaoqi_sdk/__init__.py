"""A client for a Nao's services, over the robot's own wire (qi messaging), in pure Python.

    from usarnaoqi_sdk import Session

    with Session("tcp://127.0.0.1:9559") as session:
        motion = session.service("ALMotion")
        motion.setAngles("HeadYaw", 0.5, 0.1)

The `naoqi` module beside this package offers the same under Aldebaran's names (ALProxy).
"""

from .errors import CallError, ConnectionLost, ConversionError, DecodeError, QiError
from .future import Future
from .remote_object import RemoteObject
from .session import Session

__all__ = ["CallError", "ConnectionLost", "ConversionError", "DecodeError", "Future", "QiError",
           "RemoteObject", "Session"]
