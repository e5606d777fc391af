"""A domain of ROS 2 in which no other test talks."""

import socket
from contextlib import suppress


def claimed():
    """Its number, and the socket that claims it, to be kept."""
    for domain in range(1, 100):
        with suppress(OSError):
            return domain, socket.create_server(("127.0.0.1", 7400 + 250 * domain))
    raise OSError("all domains are taken")
