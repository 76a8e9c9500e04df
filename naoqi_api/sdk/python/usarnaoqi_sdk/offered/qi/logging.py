"""qi.logging: loggers by category."""

from usarnaoqi_sdk.qi.logging import *  # noqa: F401,F403
from usarnaoqi_sdk.qi.logging import __all__  # noqa: F401
