"""Prints a TCP port of the loopback interface that nobody listens on."""

import socket

with socket.create_server(("127.0.0.1", 0)) as listener:
    print(listener.getsockname()[1])
