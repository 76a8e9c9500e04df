"""Where a program is sent to: addresses written into it give way to the environment.

NAOQI_ADDRESS=host[:port] replaces host and port, NAO_IP=host the host alone.
"""

import os
from typing import Optional, Tuple

DEFAULT_PORT = 9559
DEFAULT_HOST = "127.0.0.1"


def address(host: Optional[str] = None, port: Optional[int] = None) -> str:
    """"host:port" to connect to when a program asks for these."""
    override = _bare(os.environ.get("NAOQI_ADDRESS", ""))
    chosen = override or os.environ.get("NAO_IP") or _bare(host or "") or DEFAULT_HOST
    return chosen if ":" in chosen else "%s:%d" % (chosen, int(port or DEFAULT_PORT))


def addressOfUrl(url: str) -> str:
    """The same for "tcp://host:port"; any part may be missing."""
    host, _, port = _bare(url).partition(":")
    return address(host, int(port) if port.isdigit() else None)


def split(text: str) -> Tuple[str, int]:
    host, _, port = text.partition(":")
    return host, int(port or DEFAULT_PORT)


def _bare(url: str) -> str:
    return url.split("://", 1)[-1].rstrip("/")
