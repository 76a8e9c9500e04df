"""Where a program is sent to: addresses written into it give way to the environment.

NAOQI_ADDRESS=host[:port] replaces host and port, NAO_IP=host the host alone. With several robots,
NAOQI_ADDRESS=host:port,host:port..., robot i is meant by port 9559 + i, as `usarnaoqi serve` counts
them, or else by the i-th address that the program names, from 0 on.
"""

import os
import threading
from typing import List, Optional, Tuple

DEFAULT_PORT = 9559
DEFAULT_HOST = "127.0.0.1"
THIS_MACHINE = frozenset({"localhost", "127.0.0.1", "0.0.0.0"})

_lock = threading.Lock()
_named: List[Tuple[str, int]] = []  # hosts and ports, the first one first


def address(host: Optional[str] = None, port: Optional[int] = None) -> str:
    """"host:port" to connect to when a program asks for these."""
    override = _override(_bare(host or ""), int(port or DEFAULT_PORT))
    chosen = override or os.environ.get("NAO_IP") or _bare(host or "") or DEFAULT_HOST
    return chosen if ":" in chosen else "%s:%d" % (chosen, int(port or DEFAULT_PORT))


def _override(host: str, port: int) -> str:
    robots = [_bare(one.strip()) for one in os.environ.get("NAOQI_ADDRESS", "").split(",")]
    if len(robots) == 1:
        return robots[0]
    if DEFAULT_PORT < port < DEFAULT_PORT + len(robots):
        return robots[port - DEFAULT_PORT]
    return robots[min(_orderOf(host.lower(), port), len(robots) - 1)]


def _orderOf(host: str, port: int) -> int:
    if not host:
        return 0
    one = DEFAULT_HOST if host in THIS_MACHINE else host, port
    with _lock:
        if one not in _named:
            _named.append(one)
        return _named.index(one)


def addressOfUrl(url: str) -> str:
    """The same for "tcp://host:port"; any part may be missing."""
    host, _, port = _bare(url).partition(":")
    return address(host, int(port) if port.isdigit() else None)


def split(text: str) -> Tuple[str, int]:
    host, _, port = text.partition(":")
    return host, int(port or DEFAULT_PORT)


def _bare(url: str) -> str:
    return url.split("://", 1)[-1].rstrip("/")
