"""Aldebaran's almath, in pure Python."""

from usarnaoqi_sdk.almath import *  # noqa: F401,F403
from usarnaoqi_sdk.almath import __all__  # noqa: F401
