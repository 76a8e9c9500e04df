"""libqi's Python module, over the same wire, for where no libqi is installed."""

from usarnaoqi_sdk.qi import *  # noqa: F401,F403
from usarnaoqi_sdk.qi import __all__, __version__  # noqa: F401

globals()["async"] = globals()["async_"]  # its name until Python made it a keyword
